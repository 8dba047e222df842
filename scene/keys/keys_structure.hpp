#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// [[structure]] and what stands below it.
std::vector<Table> structure_keys();

} // namespace tremolo::scene
