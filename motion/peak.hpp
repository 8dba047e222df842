#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace tremolo::motion {

/// Largest absolute value.
inline double peak(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values)
    largest = std::max(largest, std::abs(value));
  return largest;
}

} // namespace tremolo::motion
