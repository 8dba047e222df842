#pragma once

#include "scene/keys/keys.hpp"

#include <vector>

namespace tremolo::scene {

/// [motion] and its pulse.
std::vector<Table> motion_tables();
/// [stage.motion] of a shaking after the first one, and its pulse.
std::vector<Table> stage_motion_tables();

} // namespace tremolo::scene
