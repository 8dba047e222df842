#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <array>

namespace tremolo::scene {

bool mesh_is_sound(const Case& scene, const Findings& findings) {
  if (!findings.sound("mesh.size") || !findings.sound("mesh.box"))
    return false;
  for (std::size_t i = 0; i < scene.mesh.refine.size(); ++i)
    for (const char* key : {"box", "level"})
      if (!findings.sound(fmt::format("refine[{}].{}", i, key)))
        return false;
  return true;
}

std::span<const Rule> rules() {
  static constexpr std::array<Rule, 22> all = {
      record_is_readable,      strength_is_ordered,         box_fits_lattice,
      refinements_suit_mesh,   regions_are_simple,          regions_lie_in_mesh,
      regions_are_apart,       soil_reaches_boundaries,     sides_can_be_periodic,
      springs_tie_equal_cells, total_base_has_one_surface,  models_take_the_wave,
      model_files_exist,       damping_suits_models,        soils_suit_models,
      sand_has_weight,         reference_lies_in_halfspace, incident_base_lies_in_halfspace,
      time_step_is_stable,     subcycling_suits_case,       monitors_lie_in_soil,
      hosts_can_meet,
  };
  return all;
}

} // namespace tremolo::scene
