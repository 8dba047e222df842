#pragma once

// An MKZ backbone from a G/Gmax curve by nonlinear least squares,
//
//     min sum_i [ 1/(1 + beta (gamma_i/gamma_r)^s) - (G/Gmax)_i ]^2.
//
// Only the combination beta/gamma_r^s has an effect, so beta and gamma_r cannot both be found: without a
// reference strain the fit has beta = 1, and gamma_r is the strain at which G/Gmax = 1/2; with one (e.g. that
// of a whole deposit) it finds beta.
//
// The damping of the backbone is not free then: the Masing rules fix it. They give none at small strain and,
// as a rule, more than was measured at large strain. masing_against() says how much.

#include "materials/hysteretic/backbone/curves.hpp"

#include <optional>
#include <vector>

namespace tremolo::materials {

struct MkzFit {
  double reference_strain = 0.0; ///< gamma_r, 1
  double beta = 1.0;
  double exponent = 1.0;          ///< s
  bool exponent_at_limit = false; ///< s was held at an end of its range, [0.1, 1]
  double rms_residual = 0.0;      ///< of G/Gmax, over the rows of the curve
  double largest_residual = 0.0;  ///< of G/Gmax, absolute
  double strain_of_largest_residual = 0.0;
};

/// @param reference_strain  gamma_r to keep; absent: beta = 1 and gamma_r is found
/// @throws std::invalid_argument for a curve that validate() refuses or that has no reduction to fit
/// @throws std::runtime_error if the least-squares iteration does not converge
MkzFit fit_mkz(const SoilCurves& curves, std::optional<double> reference_strain = std::nullopt);

/// Damping ratios at one strain of a curve.
struct DampingComparison {
  double strain = 0.0;
  double curve = 0.0;  ///< what the curve says
  double masing = 0.0; ///< what the Masing rules make of the fitted backbone
};

/// Both dampings at every strain of the curve.
std::vector<DampingComparison> masing_against(const SoilCurves& curves, const MkzFit& fit);

} // namespace tremolo::materials
