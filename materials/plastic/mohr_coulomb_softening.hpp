#pragma once

// Strength of softening Mohr-Coulomb soil against the equivalent plastic strain e, and the return that is
// implicit in it: with h(e) the plastic strain of a return to the surface of strength at e, a step from e_n
// ends at e_n + x where
//
//     x = h(e_n + x).

#include "materials/plastic/mohr_coulomb.hpp"
#include "materials/plastic/mohr_coulomb_return.hpp"
#include "materials/tensor/elementary.hpp"
#include "materials/tensor/sine_cosine.hpp"

#include <algorithm>
#include <limits>

namespace tremolo::materials {

/// The strength of a point and how it changes with e.
struct FadingStrength {
  Strength now;
  double cohesive_rate = 0.0;     ///< d (2 c cos(phi))/de, Pa
  double sin_friction_rate = 0.0; ///< d sin(phi)/de
  double sin_dilation_rate = 0.0; ///< d sin(psi)/de
};

/// exp(-eta e); it remains constant below 1e-304.
inline double decay_at(const MohrCoulomb& law, double e) {
  return elementary::exp(-law.softening * std::min(e, 700.0 / law.softening));
}

/// Largest tensile stress that the cut-off allows, Pa.
inline double cutoff(const MohrCoulomb& law) {
  return law.tension_cutoff.value_or(std::numeric_limits<double>::infinity());
}

/// The strength after a decay; no branch, and inlined so that a loop over points runs on vectors.
/// @tparam fading_dilation  false if peak and residual dilation are the same: a loop then finds its sine once
template <bool fading_dilation>
[[gnu::always_inline]] inline FadingStrength strength_after(const MohrCoulomb& law, double cutoff,
                                                            double decay) {
  const double cohesion_left = (law.cohesion_peak - law.cohesion_residual) * decay;
  const double friction_left = (law.friction_peak - law.friction_residual) * decay;
  const double cohesion = law.cohesion_residual + cohesion_left;
  const double friction = law.friction_residual + friction_left;
  const double dilation_left = fading_dilation ? (law.dilation_peak - law.dilation_residual) * decay : 0.0;
  const SineCosine angle = sine_cosine(friction);
  FadingStrength strength;
  strength.now.cohesive = 2.0 * cohesion * angle.cosine;
  strength.now.sin_friction = angle.sine;
  const SineCosine dilation = sine_cosine(law.dilation_residual + dilation_left);
  strength.now.sin_dilation = dilation.sine;
  strength.now.apex = cohesion * angle.cosine / angle.sine; // infinite for phi = 0
  strength.now.tension = std::min(cutoff, strength.now.apex);
  strength.cohesive_rate =
      2.0 * law.softening * (cohesion * angle.sine * friction_left - cohesion_left * angle.cosine);
  strength.sin_friction_rate = -law.softening * angle.cosine * friction_left;
  strength.sin_dilation_rate = -law.softening * dilation.cosine * dilation_left;
  return strength;
}

/// The strength at an equivalent plastic strain e.
inline FadingStrength strength_at(const MohrCoulomb& law, double e) {
  return strength_after<true>(law, cutoff(law), law.softening > 0.0 ? decay_at(law, e) : 1.0);
}

/// End of a step: principal stresses and equivalent plastic strain.
struct Return {
  Principal stress{};
  double plastic_strain = 0.0;
};

/// Brings a trial stress outside of the surface back to the surface of the plastic strain that this takes.
/// @param start  strength_at(law, e)
Return implicit_return(const MohrCoulomb& law, const Principal& trial, double e, const FadingStrength& start);

} // namespace tremolo::materials
