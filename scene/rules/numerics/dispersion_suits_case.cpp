#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace tremolo::scene {

namespace {

/// A soil of the domain for which reduced dispersion has not been validated; null if there is none.
const Soil* unsuited_soil(const Case& scene) {
  for (const Soil& soil : domain_soils(scene)) {
    const materials::Response response = materials::traits(soil.law).response;
    if (response != materials::Response::elastic && response != materials::Response::hysteretic)
      return &*std::ranges::find(scene.soils, soil.name, &Soil::name);
  }
  return nullptr;
}

bool has_mpm_column(const Case& scene) {
  const auto& [sides, left, right, base] = scene.boundary;
  return left.field.model == SourceModel::mpm || right.field.model == SourceModel::mpm ||
         base.field.model == SourceModel::mpm;
}

} // namespace

void dispersion_suits_case(const Case& scene, Findings& findings) {
  if (scene.mesh.dispersion != Dispersion::reduced || !findings.sound("mesh.dispersion"))
    return;
  const auto refuse = [&](std::string_view why) {
    findings.add("mesh.dispersion", fmt::format("'dispersion' = \"reduced\" {}", why));
  };
  if (scene.time.transfer != Transfer::apic && findings.sound("time.transfer"))
    refuse("needs transfer = \"apic\": the error of FLIP is its transfer's, which it does not touch");
  if (scene.time.order != StepOrder::musl && findings.sound("time.order"))
    refuse("needs order = \"musl\": it sharpens the velocity that is mapped to the nodes once more");
  if (scene.mesh.particles_per_cell < 2 && findings.sound("mesh.particles_per_cell"))
    refuse("needs particles_per_cell = 2 to 4: one particle a cell loses more of a wave in its transfer");
  if (scene.mesh.particle_boxes != ParticleBoxes::fixed && findings.sound("mesh.particle_boxes"))
    refuse("needs particle_boxes = \"fixed\": it reads strains in boxes of its own");
  if (!scene.mesh.refine.empty())
    refuse("is for cells of one size: its differences end where levels meet, and that costs more than finer "
           "cells "
           "gain");
  if (scene.boundary.sides == Sides::periodic_springs && findings.sound("boundary.sides"))
    refuse("needs sides = \"free_field\" or \"periodic\" in [boundary]");
  if (scene.boundary.has_shaking_table() && findings.sound("boundary.base.model"))
    refuse("is for a base on ground: it was not studied at nodes that a shaking table holds");
  if (has_mpm_column(scene))
    refuse("needs a free field other than \"mpm\", whose levels read their velocities as means over nodes");
  if (scene.water)
    refuse("is for cases without [water]: the pressure of pore water would need differences of its own");
  if (!scene.structures.empty())
    refuse("is for cases without [[structure]]: what rests on sharpened soil does not stay at rest");
  if (findings.sound("soil"))
    if (const Soil* soil = unsuited_soil(scene))
      refuse(fmt::format("is for elastic and hysteretic soil: slopes that yield, as soil '{}' may, fail "
                         "seconds early with it",
                         soil->name));
}

} // namespace tremolo::scene
