#pragma once

#include "scene/case.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tremolo::scene {

/// The soils that reach below the water table, in a region or in a layer of a free field, in the order of the
/// case; none without [water].
std::vector<std::reference_wrapper<const Soil>> soils_below_table(const Case& scene);

/// Whether water flows in a soil below the table.
bool lets_water_flow(const Soil& soil);

/// Where the water is, in a few words.
std::string table_text(const GroundWater& water);

/// What water does in each of them, in words: densities, stiffness, speeds of waves, drag.
std::string water_text(const Case& scene);

} // namespace tremolo::scene
