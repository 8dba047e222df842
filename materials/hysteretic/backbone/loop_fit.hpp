#pragma once

// The reduction of loops (loop_reduction.hpp) with which a backbone has the damping of a curve,
//
//     min sum_i [ F(gamma_i) D_Masing(gamma_i) - (D_i - D_1) ]^2,     0 <= p2 <= p1 <= 1.
//
// D_1, the damping at the least strain of the curve, is left to the soil's viscous damping.

#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/hysteretic/backbone/curves.hpp"

namespace tremolo::materials {

/// @throws std::invalid_argument for a curve or a backbone that validate() refuses
LoopReduction fit_loop_reduction(const SoilCurves& curves, const Backbone& backbone);

} // namespace tremolo::materials
