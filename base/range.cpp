#include "base/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo {

bool Range::contains(double value) const {
  return std::isfinite(value) && (low_open ? value > low : value >= low) &&
         (high_open ? value < high : value <= high);
}

bool Range::bounded() const {
  return std::isfinite(low) || std::isfinite(high);
}

std::string Range::text() const {
  if (std::isfinite(low) && std::isfinite(high))
    return fmt::format("in {}{}, {}{}", low_open ? '(' : '[', low, high, high_open ? ')' : ']');
  if (std::isfinite(low))
    return fmt::format("{} {}", low_open ? ">" : ">=", low);
  if (std::isfinite(high))
    return fmt::format("{} {}", high_open ? "<" : "<=", high);
  return "finite";
}

} // namespace tremolo
