#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// Tables of the motion, the half-space and the layers.
std::vector<Table> field_keys();
/// Tables of the sides and the base.
std::vector<Table> boundary_keys();
/// Tables of what the free-field models compute with.
std::vector<Table> numerics_keys();

/// Keys of a layer, wherever a profile stands.
std::vector<Key> layer_keys();

} // namespace tremolo::scene
