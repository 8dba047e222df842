#pragma once

// Elastic and plastic moduli grow with pressure by the same factor, F = max(1e-10, (H/H_r)^d), H = p' +
// p_res.

#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/tensor/elementary.hpp"

namespace tremolo::materials {

/// F at a distance H from the apex, Pa. Real is double, or Lanes for four points.
template <typename Real>
Real pdmy03_modulus_factor(const Pdmy03& law, const Real& height) {
  const Real relative = height / (law.reference_pressure + law.residual_pressure);
  const double d = law.pressure_exponent;
  const Real power = d == 0.5 ? sqrt(relative) : elementary::pow(relative, d);
  return larger(constant<Real>(1e-10), power);
}

} // namespace tremolo::materials
