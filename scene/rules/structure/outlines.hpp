#pragma once

// Functions shared by the rules of structures.

#include "scene/case.hpp"
#include "scene/text/findings.hpp"

#include <string>

namespace tremolo::scene {

/// Path of a structure's outline: "structure[0].polygon", "structure[0].circle".
std::string outline_path(const Case& scene, std::size_t structure);

/// Whether a structure has an outline in which nothing is wrong.
bool outline_is_sound(const Case& scene, std::size_t structure, const Findings& findings);

} // namespace tremolo::scene
