#pragma once

#include <string_view>

namespace tremolo::materials {

/// Description of one entry of a point's state block for output, checkpoints and plots.
struct StateVariable {
  std::string_view name; ///< as it appears in result files
  std::string_view unit; ///< SI, "1" for none
  std::string_view meaning;
  double initial = 0.0;
  /// Whether the variable is internal to the law: checkpoints store it, frames and plots omit it.
  bool internal = false;
};

} // namespace tremolo::materials
