#pragma once

// The functions of all rules. What each asks for stands in its row of rule_table.cpp.

#include "scene/case.hpp"
#include "scene/text/findings.hpp"

namespace tremolo::scene {

/// Whether the mesh's size and box and all refinements are known and have passed their rules.
bool mesh_is_sound(const Case& scene, const Findings& findings);

void record_is_readable(const Case& scene, Findings& findings);
void box_fits_lattice(const Case& scene, Findings& findings);
void refinements_suit_mesh(const Case& scene, Findings& findings);
void regions_are_simple(const Case& scene, Findings& findings);
void regions_lie_in_mesh(const Case& scene, Findings& findings);
void regions_are_apart(const Case& scene, Findings& findings);
void regions_hold_particles(const Case& scene, Findings& findings);
void faces_carry_gravity(const Case& scene, Findings& findings);
void soil_reaches_boundaries(const Case& scene, Findings& findings);
void sides_can_be_periodic(const Case& scene, Findings& findings);
void shaking_table_suits_case(const Case& scene, Findings& findings);
void springs_tie_equal_cells(const Case& scene, Findings& findings);
void springs_suit_boundary(const Case& scene, Findings& findings);
void total_base_has_one_surface(const Case& scene, Findings& findings);
void models_take_the_wave(const Case& scene, Findings& findings);
void model_files_exist(const Case& scene, Findings& findings);
void damping_suits_models(const Case& scene, Findings& findings);
void soils_suit_models(const Case& scene, Findings& findings);
void sand_has_weight(const Case& scene, Findings& findings);
void stress_at_rest_is_carried(const Case& scene, Findings& findings);
void reference_lies_in_halfspace(const Case& scene, Findings& findings);
void columns_have_cells(const Case& scene, Findings& findings);
void incident_base_lies_in_halfspace(const Case& scene, Findings& findings);
void time_step_is_stable(const Case& scene, Findings& findings);
void flip_has_surface_along_grid(const Case& scene, Findings& findings);
void choices_go_together(const Case& scene, Findings& findings);
void dispersion_suits_case(const Case& scene, Findings& findings);
void wet_soil_has_pores(const Case& scene, Findings& findings);
void water_has_weight(const Case& scene, Findings& findings);
void phreatic_line_spans_model(const Case& scene, Findings& findings);
void water_suits_sides(const Case& scene, Findings& findings);
void seepage_can_be_found(const Case& scene, Findings& findings);
void resting_sand_is_shaken_first(const Case& scene, Findings& findings);
void time_factor_is_allowed(const Case& scene, Findings& findings);
void loads_act_on_ground(const Case& scene, Findings& findings);
void loads_find_structures(const Case& scene, Findings& findings);
void structures_have_names(const Case& scene, Findings& findings);
void structures_are_simple(const Case& scene, Findings& findings);
void structures_lie_in_mesh(const Case& scene, Findings& findings);
void structures_are_apart(const Case& scene, Findings& findings);
void structures_are_wide(const Case& scene, Findings& findings);
void structures_lie_on_finest_level(const Case& scene, Findings& findings);
void structures_touch_soil(const Case& scene, Findings& findings);
void structures_have_weight(const Case& scene, Findings& findings);
void elastic_structures_suit_water(const Case& scene, Findings& findings);
void sections_have_names(const Case& scene, Findings& findings);
void sections_cut_elastic_structures(const Case& scene, Findings& findings);
void sections_go_through(const Case& scene, Findings& findings);
void props_have_names(const Case& scene, Findings& findings);
void props_are_fastened(const Case& scene, Findings& findings);
void props_bear_their_prestress(const Case& scene, Findings& findings);
void props_suit_case(const Case& scene, Findings& findings);
void linings_have_names(const Case& scene, Findings& findings);
void linings_are_simple(const Case& scene, Findings& findings);
void linings_lie_in_ground(const Case& scene, Findings& findings);
void linings_are_apart(const Case& scene, Findings& findings);
void linings_lie_on_finest_level(const Case& scene, Findings& findings);
void linings_are_thin(const Case& scene, Findings& findings);
void hinges_lie_on_linings(const Case& scene, Findings& findings);
void linings_have_weight(const Case& scene, Findings& findings);
void earlier_models_are_sound(const Case& scene, Findings& findings);
void later_models_are_sound(const Case& scene, Findings& findings);
void earthworks_are_dry(const Case& scene, Findings& findings);
void earthworks_spare_sides(const Case& scene, Findings& findings);
void earthworks_spare_what_rides_on_soil(const Case& scene, Findings& findings);
void drainage_is_of_soils(const Case& scene, Findings& findings);
void constructions_spare_loads(const Case& scene, Findings& findings);
void monitors_lie_in_soil(const Case& scene, Findings& findings);
void monitors_lie_on_structures(const Case& scene, Findings& findings);
void lines_lie_in_soil(const Case& scene, Findings& findings);
void sliding_masses_hold_soil(const Case& scene, Findings& findings);
void hosts_can_meet(const Case& scene, Findings& findings);
void ranks_can_be_placed(const Case& scene, Findings& findings);
void mesh_resolves_pulse(const Case& scene, Findings& findings);
void wave_arrives_after_start(const Case& scene, Findings& findings);
void motion_ends_before_run(const Case& scene, Findings& findings);
void shaken_sand_rests(const Case& scene, Findings& findings);
void time_factor_errs_little(const Case& scene, Findings& findings);
void loads_are_ramped(const Case& scene, Findings& findings);
void loads_are_far_from_sides(const Case& scene, Findings& findings);
void unit_is_that_of_header(const Case& scene, Findings& findings);
void record_is_plausible(const Case& scene, Findings& findings);
void record_ends_at_rest(const Case& scene, Findings& findings);
void outcrop_moves_as_recorded(const Case& scene, Findings& findings);
void incident_base_has_dashpots(const Case& scene, Findings& findings);
void springs_have_their_field(const Case& scene, Findings& findings);
void models_know_nonlinear_soil(const Case& scene, Findings& findings);
void soil_is_that_of_halfspace(const Case& scene, Findings& findings);
void free_field_yields_like_soil(const Case& scene, Findings& findings);
void domain_is_damped_like_free_field(const Case& scene, Findings& findings);
void particles_take_all_damping(const Case& scene, Findings& findings);
void yielding_soil_does_not_lock(const Case& scene, Findings& findings);
void saturated_soil_has_water(const Case& scene, Findings& findings);
void table_lies_in_ground(const Case& scene, Findings& findings);
void water_is_stiffer_than_skeleton(const Case& scene, Findings& findings);
void sand_has_one_void_ratio(const Case& scene, Findings& findings);
void values_are_in_si_units(const Case& scene, Findings& findings);
void soil_holds_its_weight(const Case& scene, Findings& findings);
void profile_is_that_of_side(const Case& scene, Findings& findings);
void structures_slip(const Case& scene, Findings& findings);
void round_structures_roll(const Case& scene, Findings& findings);
void sections_have_cells(const Case& scene, Findings& findings);
void props_leave_the_step(const Case& scene, Findings& findings);
void hinged_linings_hold(const Case& scene, Findings& findings);
void structures_leave_the_step(const Case& scene, Findings& findings);
void mesh_resolves_frequencies(const Case& scene, Findings& findings);
void damping_leaves_the_step(const Case& scene, Findings& findings);
void softening_goes_with_cells(const Case& scene, Findings& findings);
void backbone_is_fitted(const Case& scene, Findings& findings);
void backbone_has_given_strength(const Case& scene, Findings& findings);
void stiffness_follows_pressure(const Case& scene, Findings& findings);
void laws_have_limits(const Case& scene, Findings& findings);
void tension_has_a_limit(const Case& scene, Findings& findings);
void stress_at_rest_is_near_limit(const Case& scene, Findings& findings);
void drained_soil_needs_no_permeability(const Case& scene, Findings& findings);
void monitors_lie_on_particles(const Case& scene, Findings& findings);
void sides_are_far_from_structures(const Case& scene, Findings& findings);

} // namespace tremolo::scene
