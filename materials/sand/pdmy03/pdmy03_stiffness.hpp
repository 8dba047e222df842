#pragma once

// Elastic and plastic moduli grow with pressure by the same factor, F = max(1e-10, (H/H_r)^d), H = p' +
// p_res.

#include "materials/sand/pdmy03/pdmy03.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {

/// F at a distance H from the apex, Pa.
inline double pdmy03_modulus_factor(const Pdmy03& law, double height) {
  const double relative = height / (law.reference_pressure + law.residual_pressure);
  const double d = law.pressure_exponent;
  return std::max(1e-10, d == 0.5 ? std::sqrt(relative) : std::pow(relative, d));
}

} // namespace tremolo::materials
