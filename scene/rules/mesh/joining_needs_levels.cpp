#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void joining_needs_levels(const Case& scene, Findings& findings) {
  if (scene.mesh.join_particles && scene.mesh.refine.empty() && findings.sound("mesh.join_particles") &&
      findings.sound("refine"))
    findings.add("mesh.join_particles",
                 "'join_particles' = true needs levels: add [[refine]], or set it to false");
}

} // namespace tremolo::scene
