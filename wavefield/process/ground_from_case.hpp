#pragma once

// The exact fields of a case: ground, incident wave and their plane waves, as a case file gives them.

#include "scene/case.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/wave/motion.hpp"
#include "wavefield/layers/layered_field.hpp"
#include "wavefield/superposition.hpp"

#include <string>
#include <vector>

namespace tremolo::wavefield {

/// The elastic ground of a case under a surface: its layers at small strain, and the half-space.
LayeredHalfSpace ground_from_case(const scene::Case& scene, const std::vector<scene::Layer>& layers);

Incidence incidence_of(const scene::MotionInput& wave);

/// A motion as a signal, m/s.
Signal signal_of(const scene::Motion& motion);

/// An incident wave's velocity along its polarisation at its reference point, m/s: the motion of the case,
/// or what makes the outcrop or the top of the half-space under `ground` move like it.
/// @throws motion::RecordError for a motion that cannot be read, std::invalid_argument where it has no
///         incident wave (incident_motion.hpp)
Signal incident_signal(const scene::MotionInput& wave, const LayeredHalfSpace& ground);

/// The case's plane waves in the elastic ground under a surface at the given level, m: exact.
/// @throws as incident_signal(), and std::invalid_argument for values out of range
Superposition elastic_field(const scene::Case& scene, const std::vector<scene::Layer>& layers,
                            double surface_level);

/// The case's plane waves in ground of one's own, with the motions that they have in `elastic`.
Superposition field_in(const LayeredHalfSpace& ground, const LayeredHalfSpace& elastic,
                       const scene::Case& scene, double surface_level);

} // namespace tremolo::wavefield
