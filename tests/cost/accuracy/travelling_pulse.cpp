// What the domain's schemes do to a pulse that travels: an SV Ricker pulse f of particle velocity goes up ten
// wavelengths of a periodic column, one cell wide, with N cells to the wavelength L = c/f_peak. At the
// receiver
//
//   error       sqrt( sum |v(t) - f(t - d/c)|^2 / sum |f|^2 )
//   phase       delay tau of A f(t - d/c - tau) closest to v, as a part of the period
//   amplitude   A - 1 of the same
//
// Beside them, as a yardstick, lumped linear finite elements with central differences. Prints CSV:
//
//     cost_travelling_pulse > pulse.csv

#include "mpm_domain/column/periodic_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace tremolo;
using mpm_domain::StepOrder;
using mpm_domain::Transfer;

const materials::Elasticity soil{1700.0, 40e6, 0.28};
constexpr double wavelength = 1.0; // m
constexpr double travelled = 10.0; // wavelengths from base to receiver
constexpr double above = 3.0;      // wavelengths from receiver to surface: its reflection comes too late
constexpr double peak_time = 1.5;  // periods
constexpr double peak = 1e-4;      // m/s: small strain
const double speed = soil.s_wave_speed();
const double period = wavelength / speed;
const double end_time = (travelled + 2.0 * peak_time + 0.5) * period;

double pulse(double t) {
  const double a = std::pow(std::numbers::pi * (t / period - peak_time), 2);
  return peak * (1.0 - 2.0 * a) * std::exp(-a);
}

/// Velocity (m/s) at the receiver over time (s), its distance from the base (m), and what it took.
struct Received {
  std::vector<double> time, v;
  double distance = 0.0;
  double cpu = 0.0;  ///< s
  double work = 0.0; ///< updates of particles, or of elements
};

double cpu_now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The time that the delayed pulse takes to pass the receiver.
bool passes(double t, double distance) {
  return std::abs(t - distance / speed - peak_time * period) < 1.5 * period;
}

Received through_column(int cells, const mpm_domain::Scheme& scheme, int particles_per_cell) {
  const double h = wavelength / cells;
  const double height = travelled + above;
  mpm_domain::PeriodicColumnSpec column;
  column.domain.box = {0.0, 0.0, h, height};
  column.domain.cell_size = h;
  column.domain.particles_per_cell = particles_per_cell;
  column.domain.soils = {{"soil", materials::LinearElastic{soil}}};
  column.domain.regions = {{0, {{0.0, 0.0}, {h, 0.0}, {h, height}, {0.0, height}}}};
  column.domain.scheme = scheme;
  column.half_space = soil;
  column.incident = [](double t) -> eq6::FreeField {
    return {{pulse(t), 0.0}, {0.0, 0.0, -soil.density * speed * pulse(t)}};
  };
  column.time_step = scheme.fraction * 0.65 * h / soil.p_wave_speed();
  const double begin = cpu_now();
  mpm_domain::PeriodicColumn model(column);
  const auto& levels = model.levels();
  const auto receiver =
      static_cast<std::size_t>(std::ranges::lower_bound(levels, travelled * wavelength) - levels.begin());
  Received received;
  received.distance = levels[receiver];
  const double particles = static_cast<double>(cells * particles_per_cell * particles_per_cell) * height;
  while (model.time() < end_time) {
    model.step();
    received.time.push_back(model.time());
    received.v.push_back(model.points()[receiver].velocity.x);
    received.work += particles;
  }
  received.cpu = cpu_now() - begin;
  return received;
}

/// m dv/dt = G (u_i+1 - 2 u_i + u_i-1)/h, dashpot and pulse at the base, at a fraction of h/c.
Received through_elements(int cells, double fraction) {
  const double h = wavelength / cells;
  const double dt = fraction * h / speed;
  const auto nodes = static_cast<std::size_t>(std::lround((travelled + above) * cells)) + 1;
  const auto receiver = static_cast<std::size_t>(std::lround(travelled * cells));
  const double impedance = soil.density * speed;
  std::vector<double> u(nodes), v(nodes), force(nodes);
  Received received;
  received.distance = static_cast<double>(receiver) * h;
  const double begin = cpu_now();
  for (double t = 0.0; t < end_time; t += dt) {
    std::ranges::fill(force, 0.0);
    for (std::size_t e = 0; e + 1 < nodes; ++e) {
      const double stress = soil.shear_modulus() * (u[e + 1] - u[e]) / h;
      force[e] += stress;
      force[e + 1] -= stress;
    }
    force[0] += 2.0 * impedance * pulse(t);
    const double before = v[receiver];
    for (std::size_t i = 0; i < nodes; ++i) {
      const double mass = soil.density * h * (i == 0 || i + 1 == nodes ? 0.5 : 1.0);
      const double damping = i == 0 ? 0.5 * dt * impedance : 0.0; // of v at the middle of the step
      v[i] = ((mass - damping) * v[i] + dt * force[i]) / (mass + damping);
      u[i] += dt * v[i];
    }
    received.time.push_back(t);
    received.v.push_back(0.5 * (before + v[receiver]));
    received.work += static_cast<double>(nodes - 1);
  }
  received.cpu = cpu_now() - begin;
  return received;
}

struct Deviation {
  double error = 0.0, phase = 0.0, amplitude = 0.0;
};

Deviation deviation(const Received& received) {
  const auto correlated = [&](double delay, double& exact2, double& product, double& error2) {
    exact2 = product = error2 = 0.0;
    for (std::size_t i = 0; i < received.time.size(); ++i)
      if (passes(received.time[i], received.distance + delay * speed)) {
        const double e = pulse(received.time[i] - received.distance / speed - delay);
        exact2 += e * e;
        product += e * received.v[i];
        error2 += (received.v[i] - e) * (received.v[i] - e);
      }
  };
  double exact2 = 0.0, product = 0.0, error2 = 0.0;
  correlated(0.0, exact2, product, error2);
  Deviation result{.error = std::sqrt(error2 / exact2)};
  double best = 0.0;
  for (int i = -500; i <= 1500; ++i) { // delays up to one and a half periods, in steps of a thousandth
    const double delay = 1e-3 * i * period;
    correlated(delay, exact2, product, error2);
    if (product > 0.0 && product * product / exact2 > best) {
      best = product * product / exact2;
      result.phase = delay / period;
      result.amplitude = product / exact2 - 1.0;
    }
  }
  return result;
}

void print(const std::string& scheme, int cells, const Received& received) {
  const Deviation d = deviation(received);
  fmt::print("{},{},{:.6g},{:.4f},{:.5f},{:.4g},{:.6g}\n", scheme, cells, d.error, d.phase, d.amplitude,
             received.cpu, received.work);
  std::fflush(stdout);
}

struct Named {
  std::string name;
  mpm_domain::Scheme scheme;
  int particles_per_cell = 2;
};

} // namespace

int main() {
  const std::vector<Named> schemes{
      {"FLIP usl", {Transfer::flip, StepOrder::usl}},
      {"FLIP musl", {Transfer::flip, StepOrder::musl}},
      {"APIC usl", {Transfer::apic, StepOrder::usl}},
      {"APIC musl", {Transfer::apic, StepOrder::musl}},
      {"APIC musl 1 particle", {Transfer::apic, StepOrder::musl}, 1},
      {"APIC musl 3x3 particles", {Transfer::apic, StepOrder::musl}, 3},
      {"APIC musl 4x4 particles", {Transfer::apic, StepOrder::musl}, 4},
      {"FLIP musl 3x3 particles", {Transfer::flip, StepOrder::musl}, 3},
  };
  fmt::print("scheme,cells_per_wavelength,relative_error,phase_periods,amplitude,cpu_s,updates\n");
  for (const int cells : {8, 12, 16, 24, 32, 48}) {
    for (const Named& named : schemes)
      print(named.name, cells, through_column(cells, named.scheme, named.particles_per_cell));
    print("FE lumped", cells, through_elements(cells, 0.5));
    print("FE lumped same step", cells, through_elements(cells, 0.5 * 0.65 * speed / soil.p_wave_speed()));
  }
}
