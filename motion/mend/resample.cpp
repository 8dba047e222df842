// y(t) = sum_k x_k h(t/dt - k) / sum_k h(t/dt - k),   h(u) = sinc(c u) w(c u / N),
// w(s) = exp(beta (sqrt(1 - s^2) - 1)), |s| <= 1: a window close to Kaiser's, its side lobes below exp(-beta)
// (Barnett, Magland & af Klinteberg 2019, SIAM J. Sci. Comput. 41). c is the cut-off as a part of the old
// Nyquist frequency: 1 to a finer step, the new Nyquist frequency less the window's main lobe to a coarser
// one.

#include "motion/mend/process.hpp"

#include "motion/read/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::motion {

namespace {

constexpr double beta = 15.0;
constexpr double half_width = 64.0; // N, in periods of the cut-off's sampling

/// Half the width of the fall from pass band to stop band, as a part of the cut-off: the main lobe of w.
const double half_fall =
    std::sqrt(beta * beta + std::numbers::pi * std::numbers::pi) / (std::numbers::pi * half_width);

double kernel(double u) {
  const double s = u / half_width;
  if (std::abs(s) >= 1.0)
    return 0.0;
  const double x = std::numbers::pi * u;
  return (x == 0.0 ? 1.0 : std::sin(x) / x) * std::exp(beta * (std::sqrt(1.0 - s * s) - 1.0));
}

/// The record continued by point reflection at its ends, and by what that leaves beyond its own length.
double continued(std::span<const double> samples, std::ptrdiff_t k) {
  const auto last = static_cast<std::ptrdiff_t>(samples.size()) - 1;
  const auto at = [&](std::ptrdiff_t i) {
    return samples[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
  };
  if (k < 0)
    return 2.0 * at(0) - at(-k);
  if (k > last)
    return 2.0 * at(last) - at(2 * last - k);
  return at(k);
}

/// Value at `position` steps from the first sample.
double interpolated(std::span<const double> samples, double position, double cut_off) {
  const double reach = half_width / cut_off;
  const auto first = static_cast<std::ptrdiff_t>(std::ceil(position - reach));
  const auto last = static_cast<std::ptrdiff_t>(std::floor(position + reach));
  double sum = 0.0;
  double weights = 0.0;
  for (std::ptrdiff_t k = first; k <= last; ++k) {
    const double weight = kernel(cut_off * (position - static_cast<double>(k)));
    sum += weight * continued(samples, k);
    weights += weight;
  }
  return sum / weights;
}

} // namespace

std::vector<double> resampled(std::span<const double> samples, double dt, double new_dt) {
  if (!(new_dt > 0.0) || !std::isfinite(new_dt))
    throw std::invalid_argument(fmt::format("new step {} s, must be > 0", new_dt));
  if (new_dt == dt)
    return {samples.begin(), samples.end()};
  const double steps = static_cast<double>(samples.size() - 1) * dt / new_dt;
  if (steps < 1.0 || steps > most_samples)
    throw std::invalid_argument(fmt::format("a step of {} s gives {:.4g} samples, must be from 2 to {:g}",
                                            new_dt, steps + 1.0, most_samples));
  constexpr double rounding = 1e-9;
  const auto count = static_cast<std::size_t>(std::floor(steps * (1.0 + rounding))) + 1;
  const double cut_off = new_dt > dt ? dt / new_dt * (1.0 - half_fall) : 1.0;
  std::vector<double> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = interpolated(samples, static_cast<double>(i) * new_dt / dt, cut_off);
  return result;
}

std::vector<double> shifted(std::span<const double> samples, double dt, double delay) {
  const double steps = delay / dt;
  const auto size = static_cast<double>(samples.size());
  constexpr double rounding = 1e-6;
  if (!(steps + size >= 2.0 - rounding) || !(steps + size <= most_samples))
    throw std::invalid_argument(
        fmt::format("a shift by {} s leaves no motion, or more than {:g} samples", delay, most_samples));
  // Whole steps move samples as they are; a part of a step looks that far on between them.
  const bool whole = std::abs(steps - std::round(steps)) < rounding;
  const double moved = whole ? std::round(steps) : std::ceil(steps);
  const double ahead = whole ? 0.0 : moved - steps;
  const auto offset = static_cast<std::ptrdiff_t>(moved);
  const auto count = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(samples.size()) + offset);
  std::vector<double> result(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i) - offset;
    if (k >= 0)
      result[i] = whole ? samples[static_cast<std::size_t>(k)]
                        : interpolated(samples, std::min(static_cast<double>(k) + ahead, size - 1.0), 1.0);
  }
  return result;
}

} // namespace tremolo::motion
