#pragma once

#include "scene/case.hpp"

namespace tremolo::scene {

/// Whether p lies in or on the edge of a region.
bool in_soil(const Case& scene, Point p);

/// The structure strictly within whose outline p lies; nullptr where none is.
const Structure* structure_around(const Case& scene, Point p);

/// The lining around a point, if any.
const Lining* lining_around(const Case& scene, Point p);

} // namespace tremolo::scene
