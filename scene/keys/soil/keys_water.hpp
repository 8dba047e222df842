#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// [water]
Table water_table();
/// Keys for the position of the water table, in [water] and in stages that change it.
std::vector<Key> level_keys();
/// Keys of a soil below the water table besides those of its law.
std::vector<Key> pore_keys();

} // namespace tremolo::scene
