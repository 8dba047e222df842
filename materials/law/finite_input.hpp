#pragma once

// Laws that control the error of a step compare with it, and every comparison with a value that is not a
// number is false: such a value would pass through them unseen.

#include "materials/law/points.hpp"

#include <cstddef>
#include <string_view>

namespace tremolo::materials {

/// Refuses a call in which the stress or the state of any point is not finite.
/// @param state_size  state variables of a point
/// @param checked     how many of them, the first ones, to look at
/// @throws std::domain_error naming the law, the point and the value; nothing has been changed
void check_finite(std::string_view law, const Points& points, std::size_t state_size, std::size_t checked);

} // namespace tremolo::materials
