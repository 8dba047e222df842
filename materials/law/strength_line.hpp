#pragma once

#include <functional>
#include <string_view>

namespace tremolo::materials {

/// A line of a law in the plane of p and q, positive in compression.
struct StrengthLine {
  std::string_view name;                ///< critical_state, bounding, dilation, phase_transformation, failure
  std::function<double(double)> q_of_p; ///< both in Pa
};

} // namespace tremolo::materials
