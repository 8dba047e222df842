#pragma once

// Unloading with less damping than the Masing rules have (MRDF), Phillips & Hashash (2009), Soil Dyn. Earthq.
// Eng. 29(7), 1143-1158. With gamma_m the largest |gamma| so far and G_m the secant modulus there, a curve
// after a reversal at (gamma_rev, tau_rev) is
//
//     tau = F [2 f((gamma - gamma_rev)/2) - G_m (gamma - gamma_rev)] + G_m (gamma - gamma_rev) + tau_rev,
//     F   = p1 - p2 (1 - G_m/G0)^p3,
//
// f the backbone. gamma_m changes on the backbone alone, where no loop is open. All open loops therefore
// share one F and one G_m, and the sum over the curves since first loading is
//
//     tau = F tau_M + (1 - F) G_m gamma,
//
// where tau_M is the stress of the Masing rules for the same strains. A symmetric loop keeps its tips and F
// of its area; inner loops close, as those of the Masing rules do.

#include "materials/law/parameter.hpp"

#include <cmath>
#include <vector>

namespace tremolo::materials {

/// p1, p2 and p3 of F. As they stand by default, F = 1: the Masing rules.
struct LoopReduction {
  double at_small_strain = 1.0; ///< p1, in [0, 1]
  double loss = 0.0;            ///< p2, in [0, p1]
  double exponent = 1.0;        ///< p3, in [0.1, 10]

  /// Whether there is anything to reduce.
  bool any() const { return at_small_strain != 1.0 || loss != 0.0; }
  /// F, in [0, 1], where the backbone has the reduction r = G0/G_m - 1.
  double factor(double reduction) const {
    return at_small_strain - loss * std::pow(reduction / (1.0 + reduction), exponent);
  }
};

/// Refuses a reduction whose factor leaves [0, 1]: with F above 1 unloading would be stiffer than G0.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const LoopReduction& loops);

/// Appends p1, p2 and p3 to what a law reports, where loops are reduced.
void append_loop_parameters(const LoopReduction& loops, std::vector<ParameterValue>& values);

} // namespace tremolo::materials
