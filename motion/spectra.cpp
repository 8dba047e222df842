// An oscillator of circular frequency w and damping z under the ground acceleration a(t),
//
//     u'' + 2 z w u' + w^2 u = -a(t),        a(t) = a_n + r t within a step.
//
// Particular solution: u_p = -(a_n + r t)/w^2 + 2 z r/w^3, v_p = -r/w^2. What the state (u, v) differs from
// it decays freely, so the step is exact (Nigam & Jennings 1969, Bull. Seism. Soc. Am. 59, 909-922).

#include "motion/spectra.hpp"

#include "base/samples.hpp"
#include "motion/fourier.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::motion {

namespace {

class Oscillator {
public:
  Oscillator(double omega, double damping, double dt) : omega_(omega), damping_(damping), dt_(dt) {
    const double root = std::sqrt(1.0 - damping * damping);
    const double decay = std::exp(-damping * omega * dt);
    const double sine = decay * std::sin(omega * root * dt);
    const double cosine = decay * std::cos(omega * root * dt);
    a11_ = damping / root * sine + cosine;
    a12_ = sine / (omega * root);
    a21_ = -omega / root * sine;
    a22_ = cosine - damping / root * sine;
  }

  /// Displacement after a step from ground acceleration `first` to `last`.
  double step(double first, double last) {
    const double square = omega_ * omega_;
    const double rate = (last - first) / dt_;
    const double lag = 2.0 * damping_ * rate / (square * omega_);
    const double velocity = -rate / square;
    const double free_u = u_ - (lag - first / square);
    const double free_v = v_ - velocity;
    u_ = a11_ * free_u + a12_ * free_v + (lag - last / square);
    v_ = a21_ * free_u + a22_ * free_v + velocity;
    return u_;
  }

private:
  double omega_;
  double damping_;
  double dt_;
  double a11_, a12_, a21_, a22_;
  double u_ = 0.0;
  double v_ = 0.0;
};

} // namespace

std::vector<double> oscillator(std::span<const double> acceleration, double dt, double period,
                               double damping) {
  if (!(period > 0.0) || !std::isfinite(period) || !(damping >= 0.0 && damping < 1.0))
    throw std::invalid_argument(
        fmt::format("oscillator of period {} s and damping {}: the period must be > 0, the damping in [0, 1)",
                    period, damping));
  Oscillator one(2.0 * std::numbers::pi / period, damping, dt);
  std::vector<double> u(acceleration.size(), 0.0);
  for (std::size_t n = 1; n < u.size(); ++n)
    u[n] = one.step(acceleration[n - 1], acceleration[n]);
  return u;
}

std::vector<Response> response_spectrum(std::span<const double> acceleration, double dt,
                                        std::span<const double> periods, double damping) {
  std::vector<Response> spectrum;
  spectrum.reserve(periods.size());
  for (const double period : periods) {
    const double omega = 2.0 * std::numbers::pi / period;
    const double largest = peak(oscillator(acceleration, dt, period, damping));
    spectrum.push_back({period, largest, omega * largest, omega * omega * largest});
  }
  return spectrum;
}

std::vector<double> spaced_periods(double first, double last, std::size_t count) {
  if (!(first > 0.0) || !(last > first) || !std::isfinite(last) || count < 2)
    throw std::invalid_argument(
        fmt::format("{} periods from {} to {} s: at least 2, rising from above 0", count, first, last));
  std::vector<double> periods(count);
  for (std::size_t i = 0; i < count; ++i)
    periods[i] = first * std::pow(last / first, static_cast<double>(i) / static_cast<double>(count - 1));
  return periods;
}

std::span<const double> customary_periods() {
  static constexpr std::array periods = {
      0.01,  0.02,  0.022, 0.025, 0.029, 0.03, 0.032, 0.035, 0.036, 0.04, 0.042, 0.044, 0.045, 0.046, 0.048,
      0.05,  0.055, 0.06,  0.065, 0.067, 0.07, 0.075, 0.08,  0.085, 0.09, 0.095, 0.1,   0.11,  0.12,  0.13,
      0.133, 0.14,  0.15,  0.16,  0.17,  0.18, 0.19,  0.2,   0.22,  0.24, 0.25,  0.26,  0.28,  0.29,  0.3,
      0.32,  0.34,  0.35,  0.36,  0.38,  0.4,  0.42,  0.44,  0.45,  0.46, 0.48,  0.5,   0.55,  0.6,   0.65,
      0.667, 0.7,   0.75,  0.8,   0.85,  0.9,  0.95,  1.0,   1.1,   1.2,  1.3,   1.4,   1.5,   1.6,   1.7,
      1.8,   1.9,   2.0,   2.2,   2.4,   2.5,  2.6,   2.8,   3.0,   3.2,  3.4,   3.5,   3.6,   3.8,   4.0,
      4.2,   4.4,   4.6,   4.8,   5.0,   5.5,  6.0,   6.5,   7.0,   7.5,  8.0,   8.5,   9.0,   9.5,   10.0};
  return periods;
}

std::vector<double> tabulated_periods(double first, double last, std::size_t count) {
  auto periods = spaced_periods(first, last, count);
  // Periods that differ by rounding alone count as one, the customary one.
  const auto twin = [](double period) {
    return std::ranges::any_of(customary_periods(),
                               [period](double p) { return std::abs(p - period) < 1e-9 * period; });
  };
  std::erase_if(periods, twin);
  for (const double period : customary_periods())
    if (period > first * (1.0 - 1e-9) && period < last * (1.0 + 1e-9))
      periods.push_back(period);
  std::ranges::sort(periods);
  return periods;
}

std::vector<FourierAmplitude> fourier_spectrum(std::span<const double> samples, double dt) {
  const std::size_t n = fast_length(samples.size());
  std::vector<double> padded(samples.begin(), samples.end());
  padded.resize(n, 0.0);
  const auto bins = transform(padded);
  std::vector<FourierAmplitude> spectrum(bins.size());
  for (std::size_t i = 0; i < bins.size(); ++i)
    spectrum[i] = {static_cast<double>(i) / (static_cast<double>(n) * dt), dt * std::abs(bins[i])};
  return spectrum;
}

} // namespace tremolo::motion
