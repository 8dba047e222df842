#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// [water]
Table water_table();
/// What a soil below the water table has besides its law.
std::vector<Key> pore_keys();

} // namespace tremolo::scene
