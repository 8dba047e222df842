// Arias intensity I(t) = pi/(2 g) int_0^t a^2 dt (Arias 1970); significant duration between 5 and 95 % of it
// (Trifunac & Brady 1975); mean period T_m = sum(C_i^2 / f_i) / sum(C_i^2) with the Fourier amplitudes C_i at
// 0.25 <= f_i <= 20 Hz (Rathje, Abrahamson & Bray 1998).

#include "motion/record.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fft_real.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace tremolo::motion {

namespace {

double peak(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values)
    largest = std::max(largest, std::abs(value));
  return largest;
}

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
  // Zero padding to a power of two only samples the same spectrum more finely.
  const std::size_t n = std::bit_ceil(acceleration.size());
  std::vector<double> spectrum(acceleration.begin(), acceleration.end());
  spectrum.resize(n, 0.0);
  gsl_fft_real_radix2_transform(spectrum.data(), 1, n);
  double power = 0.0;
  double power_over_frequency = 0.0;
  for (std::size_t i = 1; 2 * i < n; ++i) {
    const double frequency = static_cast<double>(i) / (static_cast<double>(n) * dt);
    if (frequency < 0.25 || frequency > 20.0)
      continue;
    const double square = spectrum[i] * spectrum[i] + spectrum[n - i] * spectrum[n - i];
    power += square;
    power_over_frequency += square / frequency;
  }
  return power > 0.0 ? power_over_frequency / power : 0.0;
}

} // namespace

RecordMeasures measures(std::span<const double> acceleration, double dt) {
  if (acceleration.size() < 2 || !(dt > 0.0))
    throw std::invalid_argument(fmt::format(
        "a record needs at least 2 samples and dt > 0, has {} and dt = {}", acceleration.size(), dt));
  std::vector<double> squares(acceleration.begin(), acceleration.end());
  for (double& a : squares)
    a *= std::numbers::pi / (2.0 * standard_gravity) * a;
  const auto intensity = integrate(squares, dt);
  const double arias = intensity.back();
  return {.pga = peak(acceleration),
          .pgv = peak(integrate(acceleration, dt)),
          .arias = arias,
          .significant_duration = time_of(intensity, dt, 0.95 * arias) - time_of(intensity, dt, 0.05 * arias),
          .mean_period = mean_period(acceleration, dt)};
}

} // namespace tremolo::motion
