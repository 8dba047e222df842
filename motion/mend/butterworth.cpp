// A Butterworth filter of order n has its poles on a half circle. With K = tan(pi f dt) and Q = 1/(2 cos
// theta), theta the angle of a pair of poles from the negative real axis, the bilinear transform of the
// low-pass pair 1/(s^2 + s/Q + 1) is
//
//     (K^2 + 2 K^2 z^-1 + K^2 z^-2) / ((1 + K/Q + K^2) + 2 (K^2 - 1) z^-1 + (1 - K/Q + K^2) z^-2);
//
// the high-pass pair has the numerator 1 - 2 z^-1 + z^-2. An odd order adds the real pole, (K + K z^-1) or
// (1 - z^-1) over ((1 + K) + (K - 1) z^-1).

#include "motion/mend/process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::motion {

namespace {

enum class Pass { low, high };

struct Section {
  double b0, b1, b2, a1, a2;

  void run(std::span<double> x) const {
    double s1 = 0.0;
    double s2 = 0.0;
    for (double& value : x) {
      const double out = b0 * value + s1;
      s1 = b1 * value - a1 * out + s2;
      s2 = b2 * value - a2 * out;
      value = out;
    }
  }
};

Section pair(Pass pass, double k, double theta) {
  const double damping = 2.0 * k * std::cos(theta);
  const double a0 = 1.0 + damping + k * k;
  const double b = (pass == Pass::low ? k * k : 1.0) / a0;
  return {b, (pass == Pass::low ? 2.0 : -2.0) * b, b, 2.0 * (k * k - 1.0) / a0, (1.0 - damping + k * k) / a0};
}

Section single(Pass pass, double k) {
  const double b = (pass == Pass::low ? k : 1.0) / (1.0 + k);
  return {b, pass == Pass::low ? b : -b, 0.0, (k - 1.0) / (1.0 + k), 0.0};
}

void add_sections(std::vector<Section>& sections, Pass pass, double frequency, double dt, int order) {
  const double k = std::tan(std::numbers::pi * frequency * dt);
  for (int i = 0; i < order / 2; ++i)
    sections.push_back(pair(pass, k, (2 * i + 1 + order % 2) * std::numbers::pi / (2.0 * order)));
  if (order % 2 == 1)
    sections.push_back(single(pass, k));
}

/// Steps after which the slowest pole has decayed to 1e-10.
std::size_t memory(const Band& band, double dt) {
  const double lowest = band.low > 0.0 ? band.low : band.high;
  const double rate = 2.0 * std::numbers::pi * lowest * std::sin(std::numbers::pi / (2.0 * band.order));
  const double steps = std::log(1e10) / (rate * dt);
  constexpr double most_steps = 1e7;
  if (!(steps < most_steps))
    throw std::invalid_argument(
        fmt::format("a corner of {} Hz has a memory of {:.3g} steps of {} s; at most {:g} are kept", lowest,
                    steps, dt, most_steps));
  return static_cast<std::size_t>(steps) + 1;
}

} // namespace

std::vector<double> band_passed(std::span<const double> samples, double dt, const Band& band) {
  const double nyquist = 0.5 / dt;
  const bool sound = band.low >= 0.0 && band.high >= 0.0 && (band.low > 0.0 || band.high > 0.0) &&
                     (band.high == 0.0 || band.low < band.high) && std::max(band.low, band.high) < nyquist;
  if (!sound)
    throw std::invalid_argument(
        fmt::format("band from {} to {} Hz: the corners must rise and lie below the Nyquist frequency, {} Hz "
                    "(0 leaves a side open)",
                    band.low, band.high, nyquist));
  if (band.order < 1 || band.order > 10)
    throw std::invalid_argument(fmt::format("filter order {}, must be from 1 to 10", band.order));
  std::vector<Section> sections;
  if (band.low > 0.0)
    add_sections(sections, Pass::high, band.low, dt, band.order);
  if (band.high > 0.0)
    add_sections(sections, Pass::low, band.high, dt, band.order);
  std::vector<double> x(samples.begin(), samples.end());
  x.resize(samples.size() + memory(band, dt), 0.0);
  for (int direction = 0; direction < 2; ++direction) {
    for (const Section& section : sections)
      section.run(x);
    std::ranges::reverse(x);
  }
  x.resize(samples.size());
  return x;
}

} // namespace tremolo::motion
