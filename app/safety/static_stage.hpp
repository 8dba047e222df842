#pragma once

#include "scene/case.hpp"

#include <string>

namespace tremolo::app {

/// The case as a static stage leaves it: what stands then, and the loads up to then.
/// @param scene  with gravity
/// @param stage  name of a stage that ends at rest
/// @throws std::invalid_argument for the name of another stage or of none, with those that are possible
scene::Case at_end_of(const scene::Case& scene, const std::string& stage);

/// The name of the last static stage of a case.
std::string last_static_stage(const scene::Case& scene);

} // namespace tremolo::app
