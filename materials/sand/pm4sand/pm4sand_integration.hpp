#pragma once

// Integration of PM4Sand over a strain increment, by sub-steps of bounded strain and of controlled error
// (modified Euler after Sloan, Abbo & Sheng 2001, Eng. Comput. 18): with the change c_1 at the start of a
// sub-step and c_2 at the end that c_1 leads to,
//
//     change = (c_1 + c_2)/2,    error = |c_2 - c_1|/2,
//
// measured on stress, back stress ratio and fabric. Moduli, surfaces and dilatancy are evaluated anew for
// both. The direction of loading n = (s - p alpha)/|s - p alpha| is stiff: the yield surface is small, and n
// turns to the direction of the strain within a strain of m p/(2 sqrt2 G). So c_2 takes the n that the end
// of the sub-step will have, which is the trapezoidal rule: what flows in c_2 lies along n itself, hence
//
//     n || s + (c_1(s) + 2G d_e)/2 - p alpha,    p and alpha those at the end of c_1, corrected.
//
// A sub-step that begins inside the yield surface is elastic up to it. Drift off the yield surface is taken
// out of alpha, not out of the stress, unless that would take alpha outside the bounding surface: then the
// stress goes back to that surface. Both are done at the end of c_1 and at the end of the sub-step. Four
// points go side by side, each with sub-steps of its own, until the last of them is done.

#include "materials/sand/pm4sand/pm4sand_rates.hpp"

namespace tremolo::materials::pm4 {

/// Results of an integration besides stresses and states.
struct Integrated {
  Lanes plastic_work{};  ///< J/m3; NaN where no finite stress follows: stress and state then have no meaning
  Lanes shear_modulus{}; ///< at the start, Pa; of the points that stay as they are too
  long attempts = 0;     ///< at a sub-step of the four: what the integration costs
};

/// Takes stresses and states of four points over their strain increments.
/// @param stress  what the surfaces hold, in the axes of the material, compression positive
/// @param strained  the points to take; the others stay as they are
Integrated integrate(const Pm4Sand& law, States& states, Stresses& stress, const Strains& increment,
                     const LaneMask& strained);

} // namespace tremolo::materials::pm4
