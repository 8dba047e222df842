#pragma once

// Laws that cut a step into sub-steps of bounded strain have a largest step. It is checked before any point
// of a call is touched, so that a refused call leaves stress and state as they were.

#include "materials/law/points.hpp"

#include <string_view>

namespace tremolo::materials {

/// Refuses a call in which a strain or rotation increment of any point is larger than `limit` or not a
/// number.
/// @param limit  largest absolute component of a strain increment; rotations may be up to 1 rad
/// @throws std::domain_error naming the law, the point, the value and the limit; nothing has been changed
void check_increments(std::string_view law, const Points& points, double limit);

} // namespace tremolo::materials
