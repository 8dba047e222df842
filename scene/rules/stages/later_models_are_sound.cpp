// The model after an earthwork must satisfy the same checks as the one that is shaken.

#include "scene/plan/stages/stages.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void later_models_are_sound(const Case& scene, Findings& findings) {
  for (const Earthwork& work : scene.earthworks) {
    const Case then = after_earthwork(scene, work);
    for (const auto rule :
         {regions_are_simple, regions_lie_in_mesh, regions_are_apart, regions_hold_particles,
          structures_touch_soil, linings_lie_in_ground, props_are_fastened})
      rule(then, findings);
  }
}

} // namespace tremolo::scene
