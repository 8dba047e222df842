#pragma once

// Functions shared by the rules of linings.

#include "scene/case.hpp"
#include "scene/text/findings.hpp"

#include <string>

namespace tremolo::scene {

/// Path of a lining's outer face: "lining[0].polygon", "lining[0].circle".
std::string outline_path(const Lining& lining);

/// Whether a lining has an outer face in which nothing is wrong.
bool outline_is_sound(const Lining& lining, const Findings& findings);

/// A box around an outline and two of the cells beside it on which structures and linings meet soil.
Box room_around(const Case& scene, const Polygon& outline);

} // namespace tremolo::scene
