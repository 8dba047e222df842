// Each construction stage must satisfy the same checks as the final model: its regions and structures are
// valid, do not overlap any others present in that stage, and carry the loads of that stage.

#include "scene/plan/stages/stages.hpp"
#include "scene/rules/rules.hpp"

#include <array>

namespace tremolo::scene {

void earlier_models_are_sound(const Case& scene, Findings& findings) {
  for (const ConstructionStage& construction : scene.constructions) {
    const Case then = before_construction(scene, construction);
    for (const auto rule :
         {regions_are_simple, regions_lie_in_mesh, regions_are_apart, regions_hold_particles,
          structures_are_simple, structures_lie_in_mesh, structures_are_apart, structures_are_wide,
          structures_lie_on_finest_level, structures_touch_soil, elastic_structures_suit_water,
          loads_act_on_ground, phreatic_line_spans_model, seepage_can_be_found, water_suits_sides,
          linings_lie_in_ground, linings_are_apart, props_are_fastened, props_bear_their_prestress})
      rule(then, findings);
  }
}

} // namespace tremolo::scene
