#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// Tables of soils, regions, mesh and stages.
std::vector<Table> model_keys();

} // namespace tremolo::scene
