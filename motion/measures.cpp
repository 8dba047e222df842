// Arias intensity I(t) = pi/(2 g) int_0^t a^2 dt (Arias 1970); significant duration between 5 and 95 % of it
// (Trifunac & Brady 1975), and between 5 and 75 % (Somerville et al. 1997); CAV = int |a| dt (EPRI 1988);
// mean period T_m = sum(C_i^2 / f_i) / sum(C_i^2) with the Fourier amplitudes C_i at 0.25 <= f_i <= 20 Hz
// (Rathje, Abrahamson & Bray 1998).

#include "motion/measures.hpp"

#include "base/samples.hpp"
#include "motion/record.hpp"
#include "motion/spectra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::motion {

namespace {

/// Time at which a growing integral first reaches the given value, linear between samples.
double time_of(std::span<const double> integral, double dt, double value) {
  const auto reached = std::ranges::lower_bound(integral, value);
  if (reached == integral.begin() || reached == integral.end())
    return 0.0;
  const auto i = static_cast<double>(reached - integral.begin());
  const double before = *(reached - 1);
  return dt * (i - 1.0 + (value - before) / (*reached - before));
}

double mean_period(std::span<const double> acceleration, double dt) {
  double power = 0.0;
  double power_over_frequency = 0.0;
  for (const auto& [frequency, amplitude] : fourier_spectrum(acceleration, dt)) {
    if (frequency < 0.25 || frequency > 20.0)
      continue;
    power += amplitude * amplitude;
    power_over_frequency += amplitude * amplitude / frequency;
  }
  return power > 0.0 ? power_over_frequency / power : 0.0;
}

Measures measures_of(std::span<const double> a, std::span<const double> v, std::span<const double> d,
                     double dt) {
  std::vector<double> squares(a.begin(), a.end());
  for (double& square : squares)
    square *= std::numbers::pi / (2.0 * standard_gravity) * square;
  std::vector<double> absolute(a.begin(), a.end());
  for (double& value : absolute)
    value = std::abs(value);
  const auto intensity = integrate(squares, dt);
  const double arias = intensity.back();
  return {.pga = peak(a),
          .pgv = peak(v),
          .pgd = peak(d),
          .arias = arias,
          .significant_duration = time_of(intensity, dt, 0.95 * arias) - time_of(intensity, dt, 0.05 * arias),
          .duration_5_75 = time_of(intensity, dt, 0.75 * arias) - time_of(intensity, dt, 0.05 * arias),
          .cav = integrate(absolute, dt).back(),
          .mean_period = mean_period(a, dt),
          .residual_velocity = v.back(),
          .residual_displacement = d.back()};
}

} // namespace

Measures measures(std::span<const double> acceleration, double dt) {
  if (acceleration.size() < 2 || !(dt > 0.0))
    throw std::invalid_argument(fmt::format(
        "a record needs at least 2 samples and dt > 0, has {} and dt = {}", acceleration.size(), dt));
  const auto velocity = integrate(acceleration, dt);
  return measures_of(acceleration, velocity, integrate(velocity, dt), dt);
}

Measures measures(const Record& record) {
  return measures_of(with_unit(record, Unit::m_s2).samples, with_unit(record, Unit::m_s).samples,
                     with_unit(record, Unit::m).samples, record.dt);
}

std::optional<std::string> residual_warning(const Measures& measures) {
  const double residual = std::abs(measures.residual_velocity);
  if (residual <= tolerated_residual * measures.pgv)
    return std::nullopt;
  return fmt::format(
      "residual velocity {:.4g} m/s, {:.3g} % of PGV: the motion does not end at rest; correct "
      "its baseline or filter it",
      measures.residual_velocity, 100.0 * residual / measures.pgv);
}

} // namespace tremolo::motion
