#pragma once

#include <string>
#include <string_view>

namespace tremolo::materials {

/// One parameter of a law as `tremolo explain` and `tremolo soiltest` print it.
struct ParameterValue {
  std::string_view name; ///< as in the case file
  double value = 0.0;
  std::string_view unit;    ///< "1" for none
  std::string_view meaning; ///< a few words
  std::string origin; ///< "given", or the rule it follows from, e.g. "default: max(0.3, (0.25 + D_R)/2)"
  std::string_view word = {}; ///< of a choice, what the file says; `value` is its number
};

} // namespace tremolo::materials
