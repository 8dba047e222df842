#pragma once

// Cyclic strength of clean sand under any vertical stress, after Idriss & Boulanger (2008), Soil liquefaction
// during earthquakes, EERI MNO-12: their curve at 1 atm times the overburden factor
//
//     K_sigma = 1 - C_sigma ln(sigma'_v/p_a) <= 1.1,    C_sigma = 1/(18.9 - 17.3 D_R) <= 0.3.

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

/// p_a, Pa
inline constexpr double one_atmosphere = 101.3e3;

/// @param vertical_stress  effective, compression positive, Pa
inline double overburden_factor(double relative_density, double vertical_stress) {
  constexpr double largest_slope = 0.3;
  const double slope = 1.0 / std::max(18.9 - 17.3 * relative_density, 1.0 / largest_slope);
  return std::min(1.0 - slope * std::log(vertical_stress / one_atmosphere), 1.1);
}

/// A cyclic strength of that curve.
struct CurveStrength {
  double at_one_atmosphere = 0.0; ///< CSR at 1 atm
  double overburden_factor = 1.0; ///< K_sigma
  double stress_ratio() const { return at_one_atmosphere * overburden_factor; }
};

} // namespace tremolo::scene
