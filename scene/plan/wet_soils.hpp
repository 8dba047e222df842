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

/// A few words on the position of the water.
std::string table_text(const GroundWater& water);

/// A text on the water in each of these soils: densities, stiffness, wave speeds, drag.
std::string water_text(const Case& scene);

} // namespace tremolo::scene
