#pragma once

#include "scene/case.hpp"

#include <string>

namespace tremolo::app {

/// A line that says how strong a case's motion is as incident wave, at an outcrop, and at the surface of the
/// elastic free field of the left side; what of it is not known is left out, with the reason.
std::string motion_levels_text(const scene::Case& scene);

} // namespace tremolo::app
