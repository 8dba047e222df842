#pragma once

#include "motion/record.hpp"

#include <string>
#include <vector>

namespace tremolo::motion {

/// Beyond these a motion is more likely misread than real.
inline constexpr double largest_pga_g = 2.0;
inline constexpr double largest_pgv = 5.0;  // m/s
inline constexpr double longest_step = 0.1; // s

/// Doubts about a record, each a sentence with the value and the likely cause: what its reader
/// found (Origin::doubts), then PGA, PGV and step.
std::vector<std::string> doubts(const Record& record);

} // namespace tremolo::motion
