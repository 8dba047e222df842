#pragma once

#include <limits>
#include <string>

namespace tremolo {

/// Allowed values of a number.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;

  /// False for a number that is not finite.
  bool contains(double value) const;
  bool bounded() const;
  /// "> 0", ">= 1", "in [0, 90)"
  std::string text() const;
};

inline constexpr Range above_zero = {.low = 0.0, .low_open = true};
inline constexpr Range from_zero = {.low = 0.0};

} // namespace tremolo
