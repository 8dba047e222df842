#include "motion/mend/process.hpp"

#include "base/samples.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::motion {

std::vector<double> tapered(std::vector<double> samples, double dt, double begin, double end) {
  const double duration = static_cast<double>(samples.size() - 1) * dt;
  if (!(begin >= 0.0) || !(end >= 0.0) || !(begin + end <= duration))
    throw std::invalid_argument(
        fmt::format("tapers of {} s and {} s do not fit a motion of {} s", begin, end, duration));
  const auto rising = [](double s) { return 0.5 * (1.0 - std::cos(std::numbers::pi * s)); };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) * dt;
    if (t < begin)
      samples[i] *= rising(t / begin);
    if (duration - t < end)
      samples[i] *= rising((duration - t) / end);
  }
  return samples;
}

std::vector<double> scaled_to_peak(std::vector<double> samples, double wanted) {
  const double found = peak(samples);
  if (!(wanted > 0.0) || !std::isfinite(wanted) || !(found > 0.0))
    throw std::invalid_argument(
        fmt::format("cannot scale a motion whose peak is {} to {}: both must be > 0", found, wanted));
  for (double& sample : samples)
    sample *= wanted / found;
  return samples;
}

std::pair<std::vector<double>, std::vector<double>> rotated(std::span<const double> first,
                                                            std::span<const double> second, double degrees) {
  if (first.size() != second.size())
    throw std::invalid_argument(fmt::format("two components of one motion are needed: {} and {} samples",
                                            first.size(), second.size()));
  const double angle = degrees * std::numbers::pi / 180.0;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  std::pair<std::vector<double>, std::vector<double>> turned(first.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    turned.first[i] = c * first[i] + s * second[i];
    turned.second[i] = c * second[i] - s * first[i];
  }
  return turned;
}

} // namespace tremolo::motion
