#pragma once

// Strength of softening Mohr-Coulomb soil against the equivalent plastic strain e, and the return that is
// implicit in it: with h(e) the plastic strain of a return to the surface of strength at e, a step from e_n
// ends at e_n + x where
//
//     x = h(e_n + x).

#include "materials/elementary.hpp"
#include "materials/mohr_coulomb.hpp"
#include "materials/mohr_coulomb_return.hpp"
#include "materials/sine_cosine.hpp"

#include <algorithm>
#include <limits>

namespace tremolo::materials {

/// The strength of a point and how it changes with e.
struct FadingStrength {
  Strength now;
  double cohesive_rate = 0.0;     ///< d (2 c cos(phi))/de, Pa
  double sin_friction_rate = 0.0; ///< d sin(phi)/de
};

/// The strength at an equivalent plastic strain e.
inline FadingStrength strength_at(const MohrCoulomb& law, double e) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double gone = -700.0; // exp of it leaves 1e-304
  const double decay = law.softening > 0.0 ? elementary::exp(std::max(-law.softening * e, gone)) : 1.0;
  const double cohesion_left = (law.cohesion_peak - law.cohesion_residual) * decay;
  const double friction_left = (law.friction_peak - law.friction_residual) * decay;
  const double cohesion = law.cohesion_residual + cohesion_left;
  const double friction = law.friction_residual + friction_left;
  const double dilation = law.dilation_residual + (law.dilation_peak - law.dilation_residual) * decay;
  const auto [sine, cosine] = sine_cosine(friction);
  FadingStrength strength;
  strength.now.cohesive = 2.0 * cohesion * cosine;
  strength.now.sin_friction = sine;
  strength.now.sin_dilation = dilation == 0.0 ? 0.0 : sine_cosine(dilation).sine;
  strength.now.apex = sine > 0.0 ? cohesion * cosine / sine : infinity;
  strength.now.tension = std::min(law.tension_cutoff.value_or(infinity), strength.now.apex);
  strength.cohesive_rate = 2.0 * law.softening * (cohesion * sine * friction_left - cohesion_left * cosine);
  strength.sin_friction_rate = -law.softening * cosine * friction_left;
  return strength;
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
