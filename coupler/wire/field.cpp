#include "coupler/wire/field.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace tremolo::coupler {

void validate(const FieldDescription& field) {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("field '{}': {}", field.name, what));
  };
  if (field.name.empty())
    refuse("name is empty");
  if (field.y.empty())
    refuse("y has no points, expected at least one elevation (m)");
  for (std::size_t i = 0; i < field.y.size(); ++i) {
    if (!std::isfinite(field.y[i]))
      refuse(fmt::format("y[{}] is {}, expected a finite elevation (m)", i, field.y[i]));
    if (i > 0 && field.y[i] < field.y[i - 1])
      refuse(fmt::format("y[{}] = {} m lies below y[{}] = {} m, expected ascending elevations", i, field.y[i],
                         i - 1, field.y[i - 1]));
    if (i > 1 && field.y[i] == field.y[i - 2])
      refuse(
          fmt::format("the elevation {} m stands three times, expected twice at most: its values from below "
                      "and from above",
                      field.y[i]));
  }
  if (!std::isfinite(field.x_reference) || !std::isfinite(field.slowness_x) ||
      !std::isfinite(field.start_time))
    refuse(fmt::format("x_reference {} m, slowness_x {} s/m and start_time {} s must be finite",
                       field.x_reference, field.slowness_x, field.start_time));
  if (!std::isfinite(field.time_step) || field.time_step <= 0.0)
    refuse(fmt::format("time_step is {} s, expected a positive number", field.time_step));
  if (field.step_count < 2)
    refuse(fmt::format("step_count is {}, expected at least 2", field.step_count));
}

bool adds_to(const FieldDescription& field, std::string_view asked) {
  return std::string_view(field.name).substr(0, field.name.find('+')) == asked;
}

std::uint32_t steps_per_frame(const FieldDescription& field, std::uint32_t window_steps) {
  constexpr std::size_t most_bytes = std::size_t{1} << 20;
  const std::size_t fitting = most_bytes / (field.values_per_step() * sizeof(double));
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(fitting, 1, window_steps));
}

} // namespace tremolo::coupler
