#pragma once

// A model of which only a part may fail: where its other soil is weaker, as a second slope is, that would
// fail first. Soil beside the part becomes elastic. All that moves then moves inside the part, so that its
// factor of safety is that of the weakest mechanism that lies in it as a whole, and never less than that of
// the model.

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

/// The model with elastic soil to the left of x_min and to the right of x_max, m.
Spec held_beside(Spec spec, double x_min, double x_max);

/// Distance from a point to the nearest particle of soil, m.
double distance_to_soil(const Ground& ground, Vector point);

} // namespace tremolo::mpm_domain
