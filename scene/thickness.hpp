#pragma once

#include "scene/geometry.hpp"

namespace tremolo::scene {

/// The least way through a body, from the middle of each edge of its outline and its hole at right angles to
/// that edge, m. Both are simple polygons.
/// @param hole  empty where there is none
double thickness(const Polygon& outline, const Polygon& hole);

} // namespace tremolo::scene
