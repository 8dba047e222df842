// Conversion of an imported motion into a field that can be recorded: units, signs, even steps, rates.

#include "app/recording/import_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace tremolo::app {

namespace {

constexpr std::size_t vx = 0, vy = 1, sxx = 2, sxy = 4;

/// Steps that differ by less than this part of one are even: times are written with some six digits.
constexpr double rounding_of_times = 1e-2;

/// The step of times that are even, s; nothing for others.
std::optional<double> even_step(const std::vector<double>& times) {
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  for (std::size_t i = 0; i < times.size(); ++i)
    if (std::abs(times[i] - times.front() - static_cast<double>(i) * step) > rounding_of_times * step)
      return std::nullopt;
  return step;
}

/// Derivative at times[i] of the parabola through three times around it.
double parabola_slope(const std::vector<double>& times, std::span<const double> f, std::size_t i) {
  const std::size_t j = std::clamp<std::size_t>(i, 1, times.size() - 2);
  const double h0 = times[j] - times[j - 1];
  const double h1 = times[j + 1] - times[j];
  const double s0 = (f[j] - f[j - 1]) / h0;
  const double s1 = (f[j + 1] - f[j]) / h1;
  const double curvature = (s1 - s0) / (h0 + h1);
  return s0 + curvature * (2.0 * times[i] - times[j - 1] - times[j]);
}

/// Cubic Hermite with these slopes: third order, exact for parabolas.
std::vector<double> resampled(const std::vector<double>& times, std::span<const double> f, double step,
                              std::size_t count) {
  std::vector<double> values;
  values.reserve(count);
  std::size_t i = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const double t = times.front() + static_cast<double>(n) * step;
    while (i + 2 < times.size() && t > times[i + 1])
      ++i;
    const double h = times[i + 1] - times[i];
    const double s = (t - times[i]) / h;
    const double m0 = parabola_slope(times, f, i) * h;
    const double m1 = parabola_slope(times, f, i + 1) * h;
    values.push_back((1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s) * f[i] + s * (1.0 - s) * (1.0 - s) * m0 +
                     s * s * (3.0 - 2.0 * s) * f[i + 1] + s * s * (s - 1.0) * m1);
  }
  return values;
}

/// Derivatives on even steps by five points, centred where there are two on either side; fourth order.
std::vector<double> rates(const std::vector<double>& f, double step) {
  constexpr std::array<std::array<double, 5>, 5> weights{{{-25.0, 48.0, -36.0, 16.0, -3.0},
                                                          {-3.0, -10.0, 18.0, -6.0, 1.0},
                                                          {1.0, -8.0, 0.0, 8.0, -1.0},
                                                          {-1.0, 6.0, -18.0, 10.0, 3.0},
                                                          {3.0, -16.0, 36.0, -48.0, 25.0}}};
  std::vector<double> derivative(f.size());
  for (std::size_t i = 0; i < f.size(); ++i) {
    const std::size_t first = std::clamp<std::size_t>(i, 2, f.size() - 3) - 2;
    for (std::size_t k = 0; k < 5; ++k)
      derivative[i] += weights[i - first][k] * f[first + k] / (12.0 * step);
  }
  return derivative;
}

/// Factor from a file's value to SI and this project's signs. A turn of the vertical axis turns vy and, of
/// the stresses, the shear stress alone.
double factor(std::size_t value, const Conventions& c) {
  const double turned = c.vertical_down && (value == vy || value == sxy) ? -1.0 : 1.0;
  return value < sxx ? turned * c.velocity_unit : turned * c.stress_unit * (c.compression ? -1.0 : 1.0);
}

std::vector<double> levels(const ReadMotion& motion, const Conventions& c) {
  std::vector<double> y;
  for (const double depth : motion.depths)
    y.push_back(c.surface + (c.depth_down ? -1.0 : 1.0) * c.length_unit * depth);
  return y;
}

struct Steps {
  double step = 0.0;
  std::size_t count = 0;
  bool resample = false;
};

Steps steps_of(const std::vector<double>& times, const std::optional<double>& resample) {
  constexpr std::size_t fewest = 5;
  constexpr double most = 1e7;
  if (times.size() < fewest)
    throw std::runtime_error(fmt::format("{} times, at least {} are needed", times.size(), fewest));
  const auto even = even_step(times);
  if (!resample && even)
    return {*even, times.size(), false};
  if (!resample)
    throw std::runtime_error(fmt::format("the times from {} to {} s are not evenly spaced: from {} to {} s "
                                         "at first; --resample DT interpolates to an "
                                         "even step, by cubics of third order",
                                         times.front(), times.back(), times[0], times[1]));
  const double count = std::floor((times.back() - times.front()) / *resample + 1e-9) + 1.0;
  if (!(count >= static_cast<double>(fewest) && count <= most))
    throw std::runtime_error(
        fmt::format("--resample: {} s makes {} steps from {} to {} s, allowed are {} to {}", *resample, count,
                    times.front(), times.back(), fewest, most));
  return {*resample, static_cast<std::size_t>(count), true};
}

} // namespace

coupler::ServedSeries field_from(const ReadMotion& motion, const Conventions& conventions) {
  const Steps steps = steps_of(motion.times, conventions.resample);
  const std::size_t points = motion.depths.size();
  coupler::ServedSeries series{.field = {.name = conventions.field,
                                         .y = levels(motion, conventions),
                                         .x_reference = conventions.x,
                                         .slowness_x = conventions.slowness_x,
                                         .start_time = motion.times.front() + conventions.time_shift,
                                         .time_step = steps.step,
                                         .step_count = steps.count},
                               .values = {}};
  series.values.resize(steps.count * points * coupler::values_per_point);
  std::vector<double> history(motion.times.size());
  for (std::size_t point = 0; point < points; ++point)
    for (std::size_t v = 0; v < imported_values; ++v) {
      for (std::size_t i = 0; i < history.size(); ++i)
        history[i] = factor(v, conventions) * motion.values[(i * points + point) * imported_values + v];
      if (const double initial = history.front(); conventions.remove_initial && v >= sxx)
        for (double& value : history)
          value -= initial;
      const auto even = steps.resample ? resampled(motion.times, history, steps.step, steps.count) : history;
      const auto derivative = rates(even, steps.step);
      for (std::size_t i = 0; i < steps.count; ++i) {
        double* at = series.values.data() + (i * points + point) * coupler::values_per_point;
        at[v] = even[i];
        at[v + imported_values] = derivative[i];
      }
    }
  coupler::validate(series.field);
  return series;
}

} // namespace tremolo::app
