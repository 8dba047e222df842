#pragma once

#include <string_view>

namespace tremolo::materials {

/// What output, checkpoints and plots know of one entry of a point's state block.
struct StateVariable {
  std::string_view name; ///< as it appears in result files
  std::string_view unit; ///< SI, "1" for none
  std::string_view meaning;
  double initial = 0.0;
  /// What the law remembers for itself: checkpoints keep it, frames and plots leave it out.
  bool internal = false;
};

} // namespace tremolo::materials
