#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// [water]
Table water_table();
/// Where the water is: keys of [water], and of a stage that changes it.
std::vector<Key> level_keys();
/// What a soil below the water table has besides its law.
std::vector<Key> pore_keys();

} // namespace tremolo::scene
