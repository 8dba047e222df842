#pragma once

// The backbone with a given strength (quadratic_shape.hpp) that comes closest to a G/Gmax curve, by nonlinear
// least squares,
//
//     min sum_i [ 1/(1 + r(gamma_i; theta)) - (G/Gmax)_i ]^2,     theta1 < 1,   0 <= theta1 + theta2 < 1.
//
// Rows up to a strain of 0.1 % are fitted: beyond, the strength decides, and a curve G/Gmax G0 gamma that
// says something else has no say. With theta1 + theta2 >= 0 the strength is neared at least as fast as by the
// hyperbola. theta4 = 1, because theta3 does what it would do, and theta5 = 0.99.

#include "materials/hysteretic/backbone/curves.hpp"
#include "materials/hysteretic/backbone/quadratic_shape.hpp"

namespace tremolo::materials {

/// Engineering shear strain up to which a curve is fitted.
inline constexpr double largest_fitted_strain = 1e-3;

/// @param reference_strain  strength over G0, 1
/// @throws std::invalid_argument for a curve that validate() refuses or a strain that is not positive
/// @throws std::runtime_error if no start of the least squares ends at a backbone that validate() accepts
QuadraticShape fit_quadratic_shape(const SoilCurves& curves, double reference_strain);

} // namespace tremolo::materials
