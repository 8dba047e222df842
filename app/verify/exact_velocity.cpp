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

ExactVelocity::ExactVelocity(const wavefield::LayeredField& field, std::span<const double> levels,
                             const Range& range, double highest_frequency)
    : grid_(time_grid(range, field.slowness_x(), 1.0 / (samples_per_period * highest_frequency))),
      x_min_(range.x_min), slowness_(field.slowness_x()) {
  samples_.reserve(levels.size() * grid_.count);
  for (const double y : levels) {
    const std::array<wavefield::Point, 1> point{{{x_min_, y}}};
    const wavefield::History history =
        field.sample(point, grid_, wavefield::Part::total, velocity_and_rate).front();
    for (std::size_t i = 0; i < grid_.count; ++i)
      samples_.push_back({history.vx[i], history.vy[i], history.vx_rate[i], history.vy_rate[i]});
  }
}

ExactVelocity::Value ExactVelocity::at(std::size_t level, double x, double t) const {
  const double last = static_cast<double>(grid_.count - 1);
  const double place = std::clamp((t - slowness_ * (x - x_min_) - grid_.start) / grid_.dt, 0.0, last);
  const std::size_t step = std::min(static_cast<std::size_t>(place), grid_.count - 2);
  const Sample& a = samples_[level * grid_.count + step];
  const Sample& b = samples_[level * grid_.count + step + 1];
  const double s = place - static_cast<double>(step);
  const Jet x_part = hermite({a.vx, a.ax}, {b.vx, b.ax}, grid_.dt, s);
  const Jet y_part = hermite({a.vy, a.ay}, {b.vy, b.ay}, grid_.dt, s);
  return {x_part.value, y_part.value, x_part.rate, y_part.rate};
}

} // namespace tremolo::app
