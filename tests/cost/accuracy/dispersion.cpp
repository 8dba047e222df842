// What reduced dispersion makes of pulses, beside the scheme without it, on grounds that docs/dispersion.md
// lists. A Ricker pulse of particle velocity; N cells to its wavelength at the peak of the spectrum; steps of
// 0.6 h/c_p, less where soil is damped; relative L2 error of velocity. Prints CSV:
//
//     cost_dispersion > dispersion.csv

#include "tests/support/canyon_run.hpp"
#include "tests/support/plane_pulse.hpp"
#include "tests/support/pulse_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace tremolo;
using mpm_domain::Dispersion;
using mpm_domain::Particles;
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

/// Sends a pulse into a column through its base, from two wavelengths below to four wavelengths above.
/// @returns the time of the velocities, s
double inject(PulseColumn& column) {
  const double impedance = column.density * column.c;
  mpm_domain::Stepper stepper(column.domain, 0.0, [&](long, double t, auto, std::span<eq6::FreeField> field) {
    const double v = PulseColumn::ricker(2.0 - column.c * t);
    std::ranges::fill(field, eq6::FreeField{{v, 0.0}, {0.0, 0.0, -impedance * v}});
  });
  while (stepper.time() < 6.0 / column.c)
    stepper.step();
  return stepper.velocity_time();
}

double injected(double cells, Dispersion dispersion) {
  PulseColumn column(cells, 12.0, dispersion);
  const double time = inject(column);
  const double error =
      column.distance([&](double y) { return PulseColumn::ricker(y + 2.0 - column.c * time); });
  return error / column.size();
}

/// Relative L2 error in one soil of a column.
double error_in(const PulseColumn& column, std::size_t soil, const std::function<double(double)>& exact) {
  double error = 0.0, size = 0.0;
  for (const Particles& set : column.domain.sets)
    for (std::size_t k = 0; set.soil_index == soil && k < set.size(); ++k) {
      const double v = exact(set.y[k]);
      error += std::pow(particle_velocity(column.domain, set, k).x - v, 2);
      size += v * v;
    }
  return std::sqrt(error / size);
}

/// The velocity at y in viscous soil whose elastic dashpots at the base let a Ricker pulse in. With
/// k = w/c, the complex modulus is mu (1 + i w beta) and
///
///     v = (1/pi) Re int_0^inf V(k) 2/(1 + z) e^(i k (c t - 2) - i k y/z) dk,      z = sqrt(1 + i w beta),
///
/// V(k) being the spectrum of the pulse over its length.
double damped_ricker(double y, double time, double c, double damping_time) {
  using namespace std::complex_literals;
  constexpr double pi = std::numbers::pi;
  constexpr double step = 0.02; // 1/m: the sum repeats after 2 pi/step = 314 m
  double v = 0.0;
  for (double k = step; k < 12.0 * pi; k += step) { // e^-36 at its end
    const std::complex<double> z = std::sqrt(1.0 + 1.0i * (k * c * damping_time));
    const double spectrum = 1e-4 * k * k / (2.0 * std::pow(pi, 2.5)) * std::exp(-k * k / (4.0 * pi * pi));
    v += spectrum * (2.0 / (1.0 + z) * std::exp(1.0i * k * (c * time - 2.0 - y / z))).real() * step / pi;
  }
  return v;
}

double damped(double cells, Dispersion dispersion) {
  constexpr double damping_time = 0.2e-3; // s: 6 % of critical damping at the peak of the spectrum
  mpm_domain::Spec spec = PulseColumn::spec(cells, 12.0, dispersion);
  spec.soils.front().damping_time = damping_time;
  PulseColumn column(spec);
  const double time = inject(column);
  return error_in(column, 0, [&](double y) { return damped_ricker(y, time, column.c, damping_time); });
}

/// A column of hysteretic soil, hyperbolic with Masing's rules, whose steps end such that velocities of all
/// columns belong to equal times.
mpm_domain::Spec hysteretic(double cells, Dispersion dispersion) {
  mpm_domain::Spec spec = PulseColumn::spec(cells, 12.0, dispersion);
  const materials::Elasticity ground = PlanePulse{}.ground;
  const double largest_strain = PulseColumn::ricker(0.0) / ground.s_wave_speed();
  spec.soils.front().law = materials::MasingShear{ground, 3.0 * largest_strain};
  const double end = 6.0 / ground.s_wave_speed();
  const double steps = std::ceil(end * cells * ground.p_wave_speed() / 0.6);
  spec.scheme.dt = end / (steps - 0.5);
  return spec;
}

/// Velocities of a hysteretic column over y.
std::map<double, double> velocities_of_hysteretic(double cells, Dispersion dispersion) {
  PulseColumn column(hysteretic(cells, dispersion));
  inject(column);
  std::map<double, double> velocity;
  for (const Particles& set : column.domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      if (set.x[k] < 0.5 / cells)
        velocity[set.y[k]] = particle_velocity(column.domain, set, k).x;
  return velocity;
}

/// Error beside the velocities of a finer column, linear in between.
double beside_finest(double cells, Dispersion dispersion, const std::map<double, double>& finest) {
  PulseColumn column(hysteretic(cells, dispersion));
  inject(column);
  return error_in(column, 0, [&](double y) {
    const auto above = finest.lower_bound(y);
    const auto below = std::prev(above);
    return std::lerp(below->second, above->second, (y - below->first) / (above->first - below->first));
  });
}

/// What a wave of 30 degrees that is 80 m long meets at the surface.
enum class Surface { canyon, notch, flat };

/// Mean velocities of blocks of 4 m under it. The walls of the notch lie along the cells.
test_support::Seen under(Surface surface, double cell_size, Dispersion dispersion) {
  const test_support::Canyon canyon{.cell_size = cell_size,
                                    .width = 128.0,
                                    .depth = 48.0,
                                    .angle_deg = 30.0,
                                    .layers = false,
                                    .dispersion = dispersion,
                                    .canyon_depth = surface == Surface::flat ? 0.0 : 16.0,
                                    .notch = surface == Surface::notch,
                                    .end = 1.0};
  return run_canyon(canyon, {-64.0, -48.0, 64.0, 0.0}, 4.0);
}

/// Relative errors of the pulses that are reflected by, and let into, soil on top of the column with the same
/// density and 1/ratio of the wave speed. The exact pulses follow from
///
///     R = (ratio - 1)/(ratio + 1),      T = 1 + R.
struct AtInterface {
  double reflected, transmitted;
};
AtInterface at_interface(double cells, double ratio, Dispersion dispersion) {
  constexpr double top = 12.0, interface = 8.0, start = 5.0;
  mpm_domain::Spec spec = PulseColumn::spec(cells, top, dispersion);
  const materials::Elasticity ground = PlanePulse{}.ground;
  spec.soils.push_back(
      {"slow", materials::LinearElastic{{ground.density, ground.young / (ratio * ratio), ground.poisson}}});
  const double width = 1.0 / cells;
  spec.regions.front().polygon = {{0.0, 0.0}, {width, 0.0}, {width, interface}, {0.0, interface}};
  spec.regions.push_back({1, {{0.0, interface}, {width, interface}, {width, top}, {0.0, top}}});
  PulseColumn column(spec);
  column.lay(start, 1.0);
  column.run_to(2.0 * (interface - start) / column.c);
  const double way = column.c * column.stepper.velocity_time();
  const double r = (ratio - 1.0) / (ratio + 1.0);
  return {error_in(column, 0,
                   [&](double y) { return r * PulseColumn::ricker(2.0 * interface - y - start - way); }),
          error_in(column, 1, [&](double y) {
            return (1.0 + r) * PulseColumn::ricker(interface + ratio * (y - interface) - start - way);
          })};
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
    print("SV in through the base", cells, [&](Dispersion d) { return injected(cells, d); });
    print("SV left behind by the base", cells,
          [&](Dispersion d) { return test_support::left_behind(cells, d); });
  }
  for (const double ratio : {2.0, 5.0}) {
    const double cells = 12.0 * ratio; // in the fast soil; 12 in the slow one
    print(fmt::format("SV reflected by soil with 1/{} of the speed", ratio), cells,
          [&](Dispersion d) { return at_interface(cells, ratio, d).reflected; });
    print(fmt::format("SV let into soil with 1/{} of the speed", ratio), cells,
          [&](Dispersion d) { return at_interface(cells, ratio, d).transmitted; });
  }
  for (const double cells : {12.0, 16.0, 24.0})
    print("SV into damped soil", cells, [&](Dispersion d) { return damped(cells, d); });
  const std::map<double, double> finest = velocities_of_hysteretic(128.0, Dispersion::plain);
  for (const double cells : {8.0, 12.0, 16.0, 32.0})
    print("SV into hysteretic soil", cells, [&](Dispersion d) { return beside_finest(cells, d, finest); });
  for (const auto& [scene, surface] : {std::pair("SV at 30 degrees under a canyon", Surface::canyon),
                                       std::pair("SV at 30 degrees under a notch", Surface::notch),
                                       std::pair("SV at 30 degrees under flat ground", Surface::flat)}) {
    const test_support::Seen finest_cells = under(surface, 0.5, Dispersion::plain);
    for (const double cell_size : {4.0, 2.0, 1.0})
      print(scene, 80.0 / cell_size, [&](Dispersion d) {
        return test_support::relative_difference(under(surface, cell_size, d), finest_cells);
      });
  }
}
