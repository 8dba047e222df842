#pragma once

#include "materials/elastic/elasticity.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <string_view>

namespace tremolo::materials {

/// Refuses a parameter outside [low, high] or not a number.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
inline void check_range(std::string_view parameter, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    throw std::invalid_argument(
        fmt::format("{} = {:g} is outside [{:g}, {:g}]", parameter, value, low, high));
  }
}

/// Refuses a parameter that is not a finite positive number.
inline void check_positive(std::string_view parameter, double value) {
  if (!(value > 0.0 && value <= std::numeric_limits<double>::max()))
    throw std::invalid_argument(fmt::format("{} = {:g} must be positive and finite", parameter, value));
}

/// Refuses elastic constants without positive density and positive definite stiffness.
inline void check(const Elasticity& elastic) {
  check_positive("density", elastic.density);
  check_positive("young", elastic.young);
  if (!(elastic.poisson > -1.0 && elastic.poisson < 0.5))
    throw std::invalid_argument(fmt::format("poisson = {:g} is outside (-1, 0.5)", elastic.poisson));
}

} // namespace tremolo::materials
