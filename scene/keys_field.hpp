#pragma once

#include "scene/keys.hpp"

namespace tremolo::scene {

/// Tables of the motion and the free fields.
std::vector<Table> field_keys();

} // namespace tremolo::scene
