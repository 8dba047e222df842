#pragma once

#include "scene/case.hpp"

#include <string>

namespace tremolo::app {

/// The case as a static stage leaves it: what comes with later stages is not there yet.
/// @param stage  name of a stage that ends at rest
/// @throws std::invalid_argument for the name of another stage or of none, with those that are possible
scene::Case at_end_of(scene::Case scene, const std::string& stage);

} // namespace tremolo::app
