#pragma once

// What a case must fulfil beyond each key's own type and range, and what its user should know of it. A rule
// is a function in a file of its own: it looks at the case as read and reports what is violated, why, and how
// to mend it. Its severity stands in the list in rules.cpp. A rule whose findings are errors stays silent
// where a value that it needs is missing or wrong, since that has been reported already; the others see only
// cases without errors.

#include "scene/case.hpp"
#include "scene/text/findings.hpp"

namespace tremolo::scene {

/// Applies all rules: those whose findings are errors, and to a case without errors the others.
/// @throws CaseErrors where anything is wrong, which includes what was found before
void judge(const Case& scene, Findings& findings);

/// Whether the mesh's size and box and all refinements are known and have passed their rules.
bool mesh_is_sound(const Case& scene, const Findings& findings);

/// The motion's record can be read.
void record_is_readable(const Case& scene, Findings& findings);
/// The box has a width and a height that the particle lattice divides, and not too many particles.
void box_fits_lattice(const Case& scene, Findings& findings);
/// Boxes to refine reach into the model, and the cells are not too many.
void refinements_suit_mesh(const Case& scene, Findings& findings);
/// Polygons have an area and do not cross themselves.
void regions_are_simple(const Case& scene, Findings& findings);
/// Polygons lie in the box.
void regions_lie_in_mesh(const Case& scene, Findings& findings);
/// Polygons do not overlap.
void regions_are_apart(const Case& scene, Findings& findings);
/// What gravity leaves at the nodes of the boundary has faces that take it over.
void faces_carry_gravity(const Case& scene, Findings& findings);
/// No region is so small or thin that all particles' places pass it by.
void regions_hold_particles(const Case& scene, Findings& findings);
/// Soil reaches along both sides up to the free field's surface, and along the whole base.
void soil_reaches_boundaries(const Case& scene, Findings& findings);
/// Periodic sides go with waves that are the same all along the base, and with what can be tied or wrapped.
void sides_can_be_periodic(const Case& scene, Findings& findings);
/// A shaking table moves dry soil between walls or periodic sides, as a motion of its own prescribes.
void shaking_table_suits_case(const Case& scene, Findings& findings);
/// Springs tie particles of one side to those of the other: cells there are equal.
void springs_tie_equal_cells(const Case& scene, Findings& findings);
/// Springs stand beside dashpots, and have a centre only where there are some.
void springs_suit_boundary(const Case& scene, Findings& findings);
/// A total base field needs one surface level and one profile.
void total_base_has_one_surface(const Case& scene, Findings& findings);
/// Each free-field model can compute this wave, given as this kind of motion.
void models_take_the_wave(const Case& scene, Findings& findings);
/// A recording or a program that a side names is there.
void model_files_exist(const Case& scene, Findings& findings);
/// Damping ratios have a law of frequency, and one that the models know.
void damping_suits_models(const Case& scene, Findings& findings);
/// The models know the laws of their layers.
void soils_suit_models(const Case& scene, Findings& findings);
/// Soils whose stiffness depends on pressure have one: a gravity stage.
void sand_has_weight(const Case& scene, Findings& findings);
/// A rest_coefficient lies between the law's active and passive limits, and so does the K0 that a column
/// "fe" begins with.
void stress_at_rest_is_carried(const Case& scene, Findings& findings);
/// The reference point lies in the half-space of both sides; a `within` motion is that of its top.
void reference_lies_in_halfspace(const Case& scene, Findings& findings);
/// A base that takes the incident wave alone lies in the half-space.
void incident_base_lies_in_halfspace(const Case& scene, Findings& findings);
/// A column that is computed alone has a size of its cells; that of a complete case is half of its mesh's.
void columns_have_cells(const Case& scene, Findings& findings);
/// A fixed time step does not exceed the critical one.
void time_step_is_stable(const Case& scene, Findings& findings);
/// Where particles take the transfer FLIP, free surfaces lie on lines between cells.
void flip_has_surface_along_grid(const Case& scene, Findings& findings);
/// Levels with steps of their own need levels, and what sub-cycling is made for.
void subcycling_suits_case(const Case& scene, Findings& findings);
/// Reduced dispersion has the scheme, the mesh and the soils that it is made for.
void dispersion_suits_case(const Case& scene, Findings& findings);
/// Soil below the water table has pores, and a permeability where water flows in it.
void wet_soil_has_pores(const Case& scene, Findings& findings);
/// Pore pressure begins with the hydrostatic one: a gravity stage.
void water_has_weight(const Case& scene, Findings& findings);
/// A phreatic line goes from left to right over the whole model, above its base.
void phreatic_line_spans_model(const Case& scene, Findings& findings);
/// The sides can have the levels of the water that they are given.
void water_suits_sides(const Case& scene, Findings& findings);
/// Water that seeps has levels above the base, ground between them, and a permeability everywhere.
void seepage_can_be_found(const Case& scene, Findings& findings);
/// Sand that reconsolidates in a rest does not do so before.
void resting_sand_is_shaken_first(const Case& scene, Findings& findings);
/// A rest's time factor does not make inertia count in what consolidates.
void time_factor_is_allowed(const Case& scene, Findings& findings);
/// A load lies on soil, away from what it does not go with.
void loads_act_on_ground(const Case& scene, Findings& findings);
/// No construction changes the soil that a load lies on.
void constructions_spare_loads(const Case& scene, Findings& findings);
/// What stands before a construction is as sound as what stands at last.
void earlier_models_are_sound(const Case& scene, Findings& findings);
/// Names of structures can be those of results, and are different.
void structures_have_names(const Case& scene, Findings& findings);
/// Outlines and holes have an area and do not cross themselves, and holes lie inside.
void structures_are_simple(const Case& scene, Findings& findings);
/// Structures lie two cells inside the sides and the base of the mesh.
void structures_lie_in_mesh(const Case& scene, Findings& findings);
/// Structures do not overlap.
void structures_are_apart(const Case& scene, Findings& findings);
/// Structures are two cells thick.
void structures_are_wide(const Case& scene, Findings& findings);
/// Cells within two cells of a structure's surface are of the finest level.
void structures_lie_on_finest_level(const Case& scene, Findings& findings);
/// Structures have soil next to them.
void structures_touch_soil(const Case& scene, Findings& findings);
/// Structures have weight: a gravity stage.
void structures_have_weight(const Case& scene, Findings& findings);
/// No structure stands next to an elastic one.
void elastic_structures_are_alone(const Case& scene, Findings& findings);
/// Holes of elastic structures lie above the water table.
void elastic_structures_suit_water(const Case& scene, Findings& findings);
/// The transfer and the time stepping are those that structures are made for.
void structures_suit_time_stepping(const Case& scene, Findings& findings);
/// Monitors have different names, and those that follow soil lie in it.
void monitors_lie_in_soil(const Case& scene, Findings& findings);
/// Monitors that move with a structure lie in or on it.
void monitors_lie_on_structures(const Case& scene, Findings& findings);
/// [hosts] places sides, one host for a process, at an endpoint that other machines can reach.
void hosts_can_meet(const Case& scene, Findings& findings);
/// [hosts.domain] names machines, each once.
void ranks_can_be_placed(const Case& scene, Findings& findings);

/// Cells are small enough for the frequencies of the pulse.
void mesh_resolves_pulse(const Case& scene, Findings& findings);
/// The incident wave finds the model after the shaking starts.
void wave_arrives_after_start(const Case& scene, Findings& findings);
/// The run lasts until the incident wave has passed.
void motion_ends_before_run(const Case& scene, Findings& findings);
/// Sand whose law knows a rest has one, from the end of strong motion on.
void shaken_sand_rests(const Case& scene, Findings& findings);
/// A load comes slowly for the ground.
void loads_are_ramped(const Case& scene, Findings& findings);
/// A rest's time factor changes the settlement by little.
void time_factor_errs_little(const Case& scene, Findings& findings);
/// The case and the record's header give the same unit.
void unit_is_that_of_header(const Case& scene, Findings& findings);
/// PGA, PGV and step of the motion's record are those of a strong motion.
void record_is_plausible(const Case& scene, Findings& findings);
/// The motion's record ends without a velocity.
void record_ends_at_rest(const Case& scene, Findings& findings);
/// A base that takes the incident wave alone has no matched layer.
void incident_base_has_dashpots(const Case& scene, Findings& findings);
/// Springs have a free field to move against, a centre where loads act, and no false loads between two
/// fields.
void springs_have_their_field(const Case& scene, Findings& findings);
/// No model of a free field takes nonlinear soil as linear.
void models_know_nonlinear_soil(const Case& scene, Findings& findings);
/// Without layers, the soils of the domain have the half-space's elasticity.
void soil_is_that_of_halfspace(const Case& scene, Findings& findings);

/// No soil that can yield lies beside an elastic free field.
void free_field_yields_like_soil(const Case& scene, Findings& findings);
/// The free field is damped like the domain beside it, at the same ratio and by the same law of frequency.
void domain_is_damped_like_free_field(const Case& scene, Findings& findings);
/// Neither the domain nor a column of its cells drops the part of Rayleigh's damping in proportion to mass.
void particles_take_all_damping(const Case& scene, Findings& findings);
/// Soil that can yield is not nearly incompressible.
void yielding_soil_does_not_lock(const Case& scene, Findings& findings);
/// Soil that weighs what saturated soil does has water.
void saturated_soil_has_water(const Case& scene, Findings& findings);
/// The water table lies in the ground.
void table_lies_in_ground(const Case& scene, Findings& findings);
/// Below the water table, water without air is stiffer than the skeleton.
void water_is_stiffer_than_skeleton(const Case& scene, Findings& findings);
/// The pores that are given are those that the law of sand has.
void sand_has_one_void_ratio(const Case& scene, Findings& findings);
/// Elastic structures need no shorter steps than the soil.
void structures_leave_the_step(const Case& scene, Findings& findings);
/// Bodies that may roll do so at the right pace.
void round_structures_roll(const Case& scene, Findings& findings);
/// Friction is the tangent of an angle.
void structures_slip(const Case& scene, Findings& findings);
/// Values are of the order that soil, rock, water and structures have in SI units.
void values_are_in_si_units(const Case& scene, Findings& findings);
/// The strength of a soil of the domain is of the order that its own weight asks for.
void soil_holds_its_weight(const Case& scene, Findings& findings);
/// The layers of a free field are the ground that the domain has at that side.
void profile_is_that_of_side(const Case& scene, Findings& findings);

/// Up to which frequency the cells resolve shear waves.
void mesh_resolves_frequencies(const Case& scene, Findings& findings);
/// How much shorter viscous damping makes the time step.
void damping_leaves_the_step(const Case& scene, Findings& findings);
/// Which softening a soil has on the cells of each level.
void softening_goes_with_cells(const Case& scene, Findings& findings);
/// Which backbone was fitted to a soil's curve, and how near it comes.
void backbone_is_fitted(const Case& scene, Findings& findings);
/// Which strength a backbone implies beside the one that is given.
void backbone_has_given_strength(const Case& scene, Findings& findings);
/// Which soils have a stiffness that goes with pressure.
void stiffness_follows_pressure(const Case& scene, Findings& findings);
/// What a soil's law is known not to do.
void laws_have_limits(const Case& scene, Findings& findings);
/// Which soils carry any tension.
void tension_has_a_limit(const Case& scene, Findings& findings);
/// Lines have different names, an extent, no more points than fit, and all of these lie in soil.
void lines_lie_in_soil(const Case& scene, Findings& findings);
/// Sliding masses have different names and sound outlines, and soil lies within.
void sliding_masses_hold_soil(const Case& scene, Findings& findings);
/// A rest_coefficient is not close to these limits.
void stress_at_rest_is_near_limit(const Case& scene, Findings& findings);
/// Soil in which no water flows has no permeability.
void drained_soil_needs_no_permeability(const Case& scene, Findings& findings);
/// Which particles the monitors follow.
void monitors_lie_on_particles(const Case& scene, Findings& findings);
/// Sides are so far from structures on yielding soil that settlement hardly depends on the box.
void sides_are_far_from_structures(const Case& scene, Findings& findings);
/// Loads end some of their widths before a side that a free field drives.
void loads_are_far_from_sides(const Case& scene, Findings& findings);

} // namespace tremolo::scene
