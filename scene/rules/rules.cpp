#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <array>

namespace tremolo::scene {

namespace {

struct Rule {
  Severity severity;
  void (*look)(const Case& scene, Findings& findings);
};

/// Errors, then warnings, then notes: the order in which they are found and printed.
constexpr std::array rules = {
    Rule{Severity::error, record_is_readable},
    Rule{Severity::error, box_fits_lattice},
    Rule{Severity::error, refinements_suit_mesh},
    Rule{Severity::error, regions_are_simple},
    Rule{Severity::error, regions_lie_in_mesh},
    Rule{Severity::error, regions_are_apart},
    Rule{Severity::error, regions_hold_particles},
    Rule{Severity::error, faces_carry_gravity},
    Rule{Severity::error, soil_reaches_boundaries},
    Rule{Severity::error, sides_can_be_periodic},
    Rule{Severity::error, shaking_table_suits_case},
    Rule{Severity::error, springs_tie_equal_cells},
    Rule{Severity::error, springs_suit_boundary},
    Rule{Severity::error, total_base_has_one_surface},
    Rule{Severity::error, models_take_the_wave},
    Rule{Severity::error, model_files_exist},
    Rule{Severity::error, damping_suits_models},
    Rule{Severity::error, soils_suit_models},
    Rule{Severity::error, sand_has_weight},
    Rule{Severity::error, stress_at_rest_is_carried},
    Rule{Severity::error, reference_lies_in_halfspace},
    Rule{Severity::error, incident_base_lies_in_halfspace},
    Rule{Severity::error, time_step_is_stable},
    Rule{Severity::error, flip_has_surface_along_grid},
    Rule{Severity::error, subcycling_suits_case},
    Rule{Severity::error, dispersion_suits_case},
    Rule{Severity::error, wet_soil_has_pores},
    Rule{Severity::error, water_has_weight},
    Rule{Severity::error, phreatic_line_spans_model},
    Rule{Severity::error, water_suits_sides},
    Rule{Severity::error, seepage_can_be_found},
    Rule{Severity::error, resting_sand_is_shaken_first},
    Rule{Severity::error, time_factor_is_allowed},
    Rule{Severity::error, loads_act_on_ground},
    Rule{Severity::error, structures_have_names},
    Rule{Severity::error, structures_are_simple},
    Rule{Severity::error, structures_lie_in_mesh},
    Rule{Severity::error, structures_are_apart},
    Rule{Severity::error, structures_are_wide},
    Rule{Severity::error, structures_lie_on_finest_level},
    Rule{Severity::error, structures_touch_soil},
    Rule{Severity::error, structures_have_weight},
    Rule{Severity::error, elastic_structures_are_alone},
    Rule{Severity::error, elastic_structures_suit_water},
    Rule{Severity::error, structures_suit_time_stepping},
    Rule{Severity::error, earlier_models_are_sound},
    Rule{Severity::error, constructions_spare_loads},
    Rule{Severity::error, monitors_lie_in_soil},
    Rule{Severity::error, monitors_lie_on_structures},
    Rule{Severity::error, lines_lie_in_soil},
    Rule{Severity::error, sliding_masses_hold_soil},
    Rule{Severity::error, hosts_can_meet},
    Rule{Severity::error, ranks_can_be_placed},

    Rule{Severity::warning, mesh_resolves_pulse},
    Rule{Severity::warning, wave_arrives_after_start},
    Rule{Severity::warning, motion_ends_before_run},
    Rule{Severity::warning, shaken_sand_rests},
    Rule{Severity::warning, time_factor_errs_little},
    Rule{Severity::warning, loads_are_ramped},
    Rule{Severity::warning, loads_are_far_from_sides},
    Rule{Severity::warning, unit_is_that_of_header},
    Rule{Severity::warning, record_is_plausible},
    Rule{Severity::warning, record_ends_at_rest},
    Rule{Severity::warning, incident_base_has_dashpots},
    Rule{Severity::warning, springs_have_their_field},
    Rule{Severity::warning, models_know_nonlinear_soil},
    Rule{Severity::warning, soil_is_that_of_halfspace},
    Rule{Severity::warning, free_field_yields_like_soil},
    Rule{Severity::warning, domain_is_damped_like_free_field},
    Rule{Severity::warning, particles_take_all_damping},
    Rule{Severity::warning, yielding_soil_does_not_lock},
    Rule{Severity::warning, saturated_soil_has_water},
    Rule{Severity::warning, table_lies_in_ground},
    Rule{Severity::warning, water_is_stiffer_than_skeleton},
    Rule{Severity::warning, sand_has_one_void_ratio},
    Rule{Severity::warning, values_are_in_si_units},
    Rule{Severity::warning, soil_holds_its_weight},
    Rule{Severity::warning, profile_is_that_of_side},
    Rule{Severity::warning, structures_slip},
    Rule{Severity::warning, round_structures_roll},
    Rule{Severity::warning, structures_leave_the_step},

    Rule{Severity::note, mesh_resolves_frequencies},
    Rule{Severity::note, damping_leaves_the_step},
    Rule{Severity::note, softening_goes_with_cells},
    Rule{Severity::note, backbone_is_fitted},
    Rule{Severity::note, backbone_has_given_strength},
    Rule{Severity::note, stiffness_follows_pressure},
    Rule{Severity::note, laws_have_limits},
    Rule{Severity::note, tension_has_a_limit},
    Rule{Severity::note, stress_at_rest_is_near_limit},
    Rule{Severity::note, drained_soil_needs_no_permeability},
    Rule{Severity::note, monitors_lie_on_particles},
    Rule{Severity::note, sides_are_far_from_structures},
};

} // namespace

bool mesh_is_sound(const Case& scene, const Findings& findings) {
  if (!findings.sound("mesh.size") || !findings.sound("mesh.box"))
    return false;
  for (std::size_t i = 0; i < scene.mesh.refine.size(); ++i)
    for (const char* key : {"box", "level"})
      if (!findings.sound(fmt::format("refine[{}].{}", i, key)))
        return false;
  return true;
}

void judge(const Case& scene, Findings& findings) {
  for (const Rule& rule : rules) {
    if (rule.severity != Severity::error)
      findings.throw_if_any();
    findings.grade(rule.severity);
    rule.look(scene, findings);
  }
}

} // namespace tremolo::scene
