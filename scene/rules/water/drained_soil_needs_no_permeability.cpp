#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

namespace {

/// Whether water seeps in one of the stages, for which every soil has a permeability.
bool seeps(const Case& scene) {
  const auto flows = [](const std::optional<GroundWater>& water) { return water && water->seepage; };
  return flows(scene.water) || std::ranges::any_of(scene.constructions, [&](const ConstructionStage& stage) {
           return flows(stage.before.water);
         });
}

} // namespace

void drained_soil_needs_no_permeability(const Case& scene, Findings& findings) {
  if (seeps(scene))
    return;
  for (const Soil& soil : scene.soils)
    if (soil.pores && soil.pores->permeability > 0.0 && soil.pores->drainage != materials::Drainage::coupled)
      findings.add(
          fmt::format("soil.{}.permeability", soil.name),
          fmt::format(
              "'permeability' = {:g} m/s is not used: drainage = \"{}\" of soil '{}' knows no flow{}; "
              "\"coupled\" does",
              soil.pores->permeability, name(soil.pores->drainage), soil.name,
              soil.pores->drainage == materials::Drainage::drained ? ", its pore pressure stays hydrostatic"
                                                                   : ", its water moves with the grains"));
}

} // namespace tremolo::scene
