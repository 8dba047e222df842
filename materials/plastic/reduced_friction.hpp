#pragma once

#include <cmath>

namespace tremolo::materials {

/// The friction angle whose tangent is that of `friction` (rad) divided by a factor.
inline double reduced_friction(double friction, double factor) {
  return std::atan(std::tan(friction) / factor);
}

} // namespace tremolo::materials
