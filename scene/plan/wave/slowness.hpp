#pragma once

// The horizontal slowness of a plane wave, p = sin(angle) / c, c the speed of its kind in the half-space: at
// another x its field is the same, later by p (x - x_0).

#include "scene/case.hpp"

namespace tremolo::scene {

/// Speed of the incident wave in the half-space, m/s; 0 where there is none.
double incident_speed(const Case& scene, const MotionInput& wave);

/// p, s/m; 0 at vertical incidence and of a shaking table.
double slowness_x(const Case& scene, const MotionInput& wave);

} // namespace tremolo::scene
