#pragma once

// The exact fields of a case: ground, incident wave and their plane waves, as a case file gives them.

#include "scene/case.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/wave/motion.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <string>
#include <vector>

namespace tremolo::wavefield {

/// The elastic ground of a case under a surface: its layers at small strain, and the half-space.
LayeredHalfSpace ground_from_case(const scene::Case& scene, const std::vector<scene::Layer>& layers);

Incidence incidence_from_case(const scene::Case& scene);

/// A motion as a signal, m/s.
Signal signal_of(const scene::Motion& motion);

/// The incident wave's velocity along its polarisation at the reference point, m/s: the motion of the case,
/// or what makes the outcrop or the top of the half-space under `ground` move like it.
/// @throws motion::RecordError for a motion that cannot be read, std::invalid_argument where it has no
///         incident wave (incident_motion.hpp)
Signal incident_signal(const scene::Case& scene, const LayeredHalfSpace& ground);

/// Exact plane waves in the elastic ground under a surface at the given level, m.
/// @throws as incident_signal(), and std::invalid_argument for values out of range
LayeredField elastic_field(const scene::Case& scene, const std::vector<scene::Layer>& layers,
                           double surface_level);

} // namespace tremolo::wavefield
