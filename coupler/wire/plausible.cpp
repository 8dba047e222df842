#include "coupler/wire/plausible.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <fmt/format.h>

namespace tremolo::coupler {

namespace {

struct Quantity {
  const char* name;
  const char* unit;
  double most; ///< allowed magnitude
};

constexpr double most_velocity = 100.0; // m/s
constexpr double most_stress = 1e10;    // Pa
constexpr double most_rate = 1e3;       // of change, 1/s: what changes within a millisecond

/// The quantities of a point, in the order of its values.
constexpr std::array<Quantity, values_per_point> quantities{{
    {"velocity vx", "m/s", most_velocity},
    {"velocity vy", "m/s", most_velocity},
    {"stress sxx", "Pa", most_stress},
    {"stress syy", "Pa", most_stress},
    {"stress sxy", "Pa", most_stress},
    {"acceleration ax", "m/s2", most_rate* most_velocity},
    {"acceleration ay", "m/s2", most_rate* most_velocity},
    {"rate of stress sxx", "Pa/s", most_rate* most_stress},
    {"rate of stress syy", "Pa/s", most_rate* most_stress},
    {"rate of stress sxy", "Pa/s", most_rate* most_stress},
}};

constexpr std::size_t point_size = values_per_point * sizeof(double);

std::array<double, values_per_point> point_at(std::span<const std::byte> values, std::size_t point) {
  std::array<double, values_per_point> some;
  std::memcpy(some.data(), values.data() + point * point_size, point_size);
  return some;
}

/// Also of a NaN.
bool is_beyond(double value, double most) {
  return !(std::abs(value) <= most);
}

} // namespace

std::optional<std::string> implausible(const FieldDescription& field, std::uint64_t first_step,
                                       std::span<const std::byte> values) {
  for (std::size_t at = 0; at < values.size() / point_size; ++at) {
    const auto numbers = point_at(values, at);
    bool any = false; // nearly never: the loop over the quantities needs no branch
    for (std::size_t q = 0; q < values_per_point; ++q)
      any |= is_beyond(numbers[q], quantities[q].most);
    for (std::size_t q = 0; any && q < values_per_point; ++q)
      if (const auto& [name, unit, most] = quantities[q]; is_beyond(numbers[q], most)) {
        const std::size_t point = at % field.y.size();
        return fmt::format("step {}: {} at y = {} m (point {} of {}) is {:g} {}, allowed are {:g} to {:g} {}",
                           first_step + at / field.y.size(), name, field.y[point], point, field.y.size(),
                           numbers[q], unit, -most, most, unit);
      }
  }
  return std::nullopt;
}

} // namespace tremolo::coupler
