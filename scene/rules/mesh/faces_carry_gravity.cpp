#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void faces_carry_gravity(const Case& scene, Findings& findings) {
  if (!scene.gravity || scene.mesh.particles_per_cell > 1 || scene.boundary.base_is_rigid() ||
      !findings.sound("mesh.particles_per_cell") || !findings.sound("boundary"))
    return;
  findings.add("mesh.particles_per_cell",
               "'particles_per_cell' = 1 with a [[stage]] of kind = \"gravity\": the boundary has one face a "
               "particle, and so fewer faces than nodes whose reactions they take over; use 2 or more");
}

} // namespace tremolo::scene
