#include "mpm_domain/spec/conflicts.hpp"
#include "scene/rules/rules.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace tremolo::scene {

namespace {

mpm_domain::Combination combination_of(const Case& scene) {
  const auto& [sides, left, right, base] = scene.boundary;
  constexpr auto layer = Absorber::matched_layer;
  return {.scheme = {.transfer = scene.time.transfer,
                     .order = scene.time.order,
                     .subcycle = scene.time.subcycle,
                     .dispersion = scene.mesh.dispersion},
          .particles_per_cell = scene.mesh.particles_per_cell,
          .boxes = scene.mesh.particle_boxes,
          .sides = sides,
          .levels = !scene.mesh.refine.empty(),
          .rigid_base = scene.boundary.base_is_rigid(),
          .matched_layer = left.absorber == layer || right.absorber == layer || base.absorber == layer,
          .water = scene.water.has_value(),
          .structures = !scene.structures.empty(),
          .linings = !scene.linings.empty(),
          .surface_loads = !std::ranges::all_of(scene.loads, &LoadStage::on_structure),
          .earthworks = !scene.earthworks.empty()};
}

} // namespace

void choices_go_together(const Case& scene, Findings& findings) {
  const mpm_domain::Combination model = combination_of(scene);
  std::vector<mpm_domain::Conflict> found; // before any of them makes a key unsound
  std::ranges::copy_if(mpm_domain::all_conflicts(), std::back_inserter(found), [&](const auto& conflict) {
    return conflict.is_in(model) && findings.sound(std::string(conflict.feature.key)) &&
           findings.sound(std::string(conflict.other.key));
  });
  for (const mpm_domain::Conflict& conflict : found)
    findings.add(std::string(conflict.feature.key), conflict.text());
}

} // namespace tremolo::scene
