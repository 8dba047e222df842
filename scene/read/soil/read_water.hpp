#pragma once

// Ground water: the table, the pores of soils, and the layers that the table cuts.

#include "scene/read/read.hpp"

namespace tremolo::scene {

/// The position of the water, from [water] or a stage that changes it; its fluid is not set yet.
GroundWater read_levels(const TableReader& table, Findings& findings);
/// [water], as it is while the ground is shaken, and what it is until each construction; after the stages and
/// before the soils.
void read_water(Document& document, Findings& findings, Case& scene);

/// The pores of a soil from its keys, or from what its law says of them. Gives the soil's table the density
/// below the water table where it names none, so that the law can be read after; refuses a density that
/// contradicts, and keys of pores without [water].
std::optional<materials::PoreSpace> read_pores(TableReader& table, const std::optional<GroundWater>& water,
                                               Findings& findings);

/// Whether none of the keys that the pores of a soil, "soil.sand", follow from has been refused.
bool pores_are_sound(const std::string& soil, const Findings& findings);

/// The void ratio that a soil's law has by its keys; nothing if it has none.
std::optional<double> void_ratio_of_law(const TableReader& table);
/// The density of the saturated soil that a law has without a key, kg/m3.
std::optional<double> saturated_density_of_law(const TableReader& table);

/// The layers under a surface, cut at the water table. Elastic constants become those that waves meet: below
/// the table those of grains and water together, above it those of dry soil. Layers without pores stay as
/// they are.
/// @param level  y of the table, m
std::vector<Layer> watered(const std::vector<Layer>& layers, double surface, double level, const Case& scene);
/// The layers of [[profile]], cut in this way.
std::vector<Layer> watered_profile(const Case& scene);
/// The layers of a side, cut at the table below its own surface.
std::vector<Layer> watered(const std::vector<Layer>& layers, const LateralBoundary& side, const Case& scene);

} // namespace tremolo::scene
