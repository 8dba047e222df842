// What reduced dispersion makes of pulses, beside the scheme without it, on grounds that docs/dispersion.md
// lists. A Ricker pulse of particle velocity; N cells to its wavelength at the peak of the spectrum; steps of
// 0.6 h/c_p; relative L2 error of velocity. Prints CSV:
//
//     cost_dispersion > dispersion.csv

#include "tests/support/plane_pulse.hpp"
#include "tests/support/pulse_column.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

namespace {

using namespace tremolo;
using mpm_domain::Dispersion;
using mpm_domain::Particles;
using mpm_domain::Vector;
using test_support::PlanePulse;
using test_support::PulseColumn;
using test_support::PulseGround;

constexpr double spacing = 3.0; // wavelengths

void print(std::string_view scene, double cells, const std::function<double(Dispersion)>& error) {
  fmt::print("{},{:.4g},{:.6g},{:.6g}\n", scene, cells, error(Dispersion::plain), error(Dispersion::reduced));
  std::fflush(stdout);
}

double travelled(const PlanePulse& pulse, const PulseGround& ground, Dispersion dispersion) {
  return test_support::travel(pulse, ground, dispersion).error;
}

void along_axis(std::string_view scene, bool sv, double cells, Vector drift = {}, double jitter = 0.0) {
  const PlanePulse pulse{.sv = sv, .wavelength = 1.0, .spacing = spacing};
  const double h = 1.0 / cells;
  const Vector speed{drift.x * pulse.ground.p_wave_speed(), drift.y * pulse.ground.p_wave_speed()};
  const double width = jitter > 0.0 ? 8.0 * h : h;
  print(scene, cells, [&](Dispersion d) {
    return travelled(pulse, {h, width, 10.0, spacing, speed, jitter * h}, d);
  });
}

void oblique(std::string_view scene, bool sv, int period, Vector drift = {}) {
  const double cells = period / std::sqrt(2.0) / spacing;
  const PlanePulse pulse{.sv = sv, .angle_deg = 45.0, .wavelength = cells, .spacing = spacing * cells};
  const Vector speed{drift.x * pulse.ground.p_wave_speed(), drift.y * pulse.ground.p_wave_speed()};
  print(scene, cells, [&](Dispersion d) {
    return travelled(pulse, {1.0, double(period), 6.0 * cells, 2.0 * cells, speed}, d);
  });
}

/// From two wavelengths below the surface and back.
double at_surface(double cells, Dispersion dispersion) {
  PulseColumn column(cells, 8.0, dispersion);
  column.lay(6.0, 1.0);
  column.run_to(4.0 / column.c);
  const double time = column.stepper.velocity_time();
  const double error =
      column.distance([&](double y) { return PulseColumn::ricker(10.0 - y - column.c * time); });
  return error / column.size();
}

/// Into the column through its base.
double injected(double cells, Dispersion dispersion) {
  PulseColumn column(cells, 12.0, dispersion);
  const double impedance = column.density * column.c;
  mpm_domain::Stepper stepper(column.domain, 0.0, [&](long, double t, auto, std::span<eq6::FreeField> field) {
    const double v = PulseColumn::ricker(2.0 - column.c * t);
    std::ranges::fill(field, eq6::FreeField{{v, 0.0}, {0.0, 0.0, -impedance * v}});
  });
  while (stepper.time() < 6.0 / column.c)
    stepper.step();
  const double time = stepper.velocity_time();
  const double error =
      column.distance([&](double y) { return PulseColumn::ricker(y + 2.0 - column.c * time); });
  return error / column.size();
}

} // namespace

int main() {
  fmt::print("scene,cells_per_wavelength,plain,reduced\n");
  for (const double cells : {8.0, 12.0, 16.0, 24.0, 32.0, 48.0}) {
    along_axis("SV along an axis", true, cells);
    along_axis("P along an axis", false, cells);
  }
  for (const int period : {34, 51, 68, 102, 136}) {
    oblique("SV at 45 degrees", true, period);
    oblique("P at 45 degrees", false, period);
  }
  along_axis("SV along an axis with a drift of 0.03 c_p", true, 16.0, {0.0, 0.03});
  along_axis("SV along an axis with an oblique drift", true, 16.0, {0.05, 0.03});
  oblique("SV at 45 degrees with an oblique drift", true, 51, {0.05, 0.03});
  along_axis("SV along an axis with places off by 0.1 h", true, 16.0, {}, 0.1);
  for (const double cells : {12.0, 16.0, 24.0, 32.0}) {
    print("SV reflected by a free surface", cells, [&](Dispersion d) { return at_surface(cells, d); });
    print("SV through a base with dashpots", cells, [&](Dispersion d) { return injected(cells, d); });
    print("SV left behind by dashpots", cells,
          [&](Dispersion d) { return test_support::left_behind(cells, d); });
  }
}
