#include "app/verify/exact_velocity.hpp"
#include "app/verify/hermite.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tremolo::app {
namespace {

constexpr wavefield::Quantities velocity_and_rate{.displacement = false, .stress = false, .strain = false};

wavefield::TimeGrid time_grid(const ExactVelocity::Range& range, double slowness, double dt) {
  const double first = range.t_min - slowness * (range.x_max - range.x_min);
  return {first, dt, static_cast<std::size_t>(std::ceil((range.t_max - first) / dt)) + 2};
}

} // namespace

ExactVelocity::Wave::Wave(const wavefield::LayeredField& field, std::span<const double> levels,
                          const Range& range, double highest_frequency)
    : slowness(field.slowness_x()),
      grid(time_grid(range, slowness, 1.0 / (samples_per_period * highest_frequency))) {
  samples.reserve(levels.size() * grid.count);
  for (const double y : levels) {
    const std::array<wavefield::Point, 1> point{{{range.x_min, y}}};
    const wavefield::History history =
        field.sample(point, grid, wavefield::Part::total, velocity_and_rate).front();
    for (std::size_t i = 0; i < grid.count; ++i)
      samples.push_back({history.vx[i], history.vy[i], history.vx_rate[i], history.vy_rate[i]});
  }
}

ExactVelocity::Value ExactVelocity::Wave::at(std::size_t level, double distance, double t) const {
  const double last = static_cast<double>(grid.count - 1);
  const double place = std::clamp((t - slowness * distance - grid.start) / grid.dt, 0.0, last);
  const std::size_t step = std::min(static_cast<std::size_t>(place), grid.count - 2);
  const Sample& a = samples[level * grid.count + step];
  const Sample& b = samples[level * grid.count + step + 1];
  const double s = place - static_cast<double>(step);
  const Jet x_part = hermite({a.vx, a.ax}, {b.vx, b.ax}, grid.dt, s);
  const Jet y_part = hermite({a.vy, a.ay}, {b.vy, b.ay}, grid.dt, s);
  return {x_part.value, y_part.value, x_part.rate, y_part.rate};
}

ExactVelocity::ExactVelocity(const wavefield::Superposition& field, std::span<const double> levels,
                             const Range& range, double highest_frequency)
    : x_min_(range.x_min) {
  for (const wavefield::LayeredField& wave : field.waves())
    waves_.emplace_back(wave, levels, range, highest_frequency);
}

ExactVelocity::Value ExactVelocity::at(std::size_t level, double x, double t) const {
  Value sum;
  for (const Wave& wave : waves_) {
    const Value v = wave.at(level, x - x_min_, t);
    sum.vx += v.vx;
    sum.vy += v.vy;
    sum.ax += v.ax;
    sum.ay += v.ay;
  }
  return sum;
}

} // namespace tremolo::app
