#pragma once

#include <string>
#include <string_view>

namespace tremolo {

/// A number, or a range of numbers, with its unit; "1" is none.
inline std::string with_unit(std::string_view text, std::string_view unit) {
  std::string all(text);
  if (!unit.empty() && unit != "1")
    all.append(" ").append(unit);
  return all;
}

} // namespace tremolo
