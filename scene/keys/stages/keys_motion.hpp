#pragma once

#include "scene/keys/keys.hpp"

#include <vector>

namespace tremolo::scene {

/// [motion], its pulse, and [motion.vertical].
std::vector<Table> motion_tables();
/// [stage.motion] of a shaking after the first one, its pulse, and its vertical component.
std::vector<Table> stage_motion_tables();

} // namespace tremolo::scene
