#include "wavefield/signal/signal.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::wavefield {

Signal ricker(double frequency_hz, double time_s, double peak_velocity) {
  require_positive("Ricker frequency", frequency_hz, "Hz");
  require(std::isfinite(time_s), "Ricker time", time_s, "finite");
  require(std::isfinite(peak_velocity), "Ricker peak velocity", peak_velocity, "finite");
  // exp(-7^2) (2 7^2 - 1) = 5e-20; the spectrum (f/fp)^2 exp(-(f/fp)^2) has fallen to 1e-26 at 8 fp.
  const double half_width = 7.0 / (std::numbers::pi * frequency_hz);
  const auto velocity = [=](double t) {
    const double z = std::numbers::pi * frequency_hz * (t - time_s);
    return std::abs(t - time_s) < half_width ? peak_velocity * (1.0 - 2.0 * z * z) * std::exp(-z * z) : 0.0;
  };
  return {velocity, time_s - half_width, time_s + half_width, 8.0 * frequency_hz};
}

double peak_velocity(const Signal& signal) {
  const double dt = 0.25 / signal.highest_frequency;
  double most = 0.0;
  for (double t = signal.begin; t <= signal.end; t += dt)
    most = std::max(most, std::abs(signal.velocity(t)));
  return most;
}

void validate(const Signal& signal) {
  if (!signal.velocity)
    throw std::invalid_argument("the signal has no velocity function");
  require(std::isfinite(signal.begin), "begin of the signal", signal.begin, "finite");
  require(signal.end > signal.begin && std::isfinite(signal.end), "end of the signal", signal.end,
          "finite and after its begin, " + shortest(signal.begin) + " s");
  require_positive("highest frequency of the signal", signal.highest_frequency, "Hz");
}

} // namespace tremolo::wavefield
