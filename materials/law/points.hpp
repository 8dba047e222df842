#pragma once

#include <cstddef>

namespace tremolo::materials {

/// A view of `count` material points, one array a quantity. Tension positive.
///
/// A law reads the strain and rotation increments of a step and updates stress and state in place. Arrays
/// hold `count` values, except `state`, which holds the law's state variables point after point.
struct Points {
  std::size_t count = 0;
  double* sxx = nullptr; ///< Cauchy stress, Pa
  double* syy = nullptr;
  double* szz = nullptr;
  double* sxy = nullptr;
  double* state = nullptr;        ///< [count][state_variables(law).size()]
  double* plastic_work = nullptr; ///< += plastic work of the step per unit volume, J/m3
  const double* dexx = nullptr;   ///< strain increments
  const double* deyy = nullptr;
  const double* dgxy = nullptr; ///< engineering shear strain increment, dux/dy + duy/dx
  const double* dwxy = nullptr; ///< rotation increment (duy/dx - dux/dy)/2, rad, counter-clockwise positive
  /// Out-of-plane strain increments, for element tests with axial symmetry; null: plane strain. Only laws
  /// with the trait three_dimensional take them.
  const double* dezz = nullptr;
};

} // namespace tremolo::materials
