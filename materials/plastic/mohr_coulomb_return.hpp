#pragma once

// Return of a trial stress to the Mohr-Coulomb surface in principal space, after de Souza Neto, Peric & Owen
// (2008), Computational Methods for Plasticity, ch. 8, and Clausen, Damkilde & Andersen (2006), Int. J.
// Numer. Meth. Eng. 66. With s1 >= s2 >= s3 and D the isotropic stiffness,
//
//     s = s_trial - sum_k lambda_k D b_k,    f_k(s) = 0,
//     main plane  13:      f13 = (s1 - s3) + (s1 + s3) sin(phi) - 2 c cos(phi),  b13 = (1 + sin(psi), 0,
//     sin(psi) - 1) right edge  13, 12:  s2 = s3, triaxial compression left edge   13, 23:  s1 = s2, triaxial
//     extension apex                 s1 = s2 = s3 = c cot(phi) cut-off              s1 = t, associated, alone
//     or together with the planes above

#include "materials/elastic/elasticity.hpp"

#include <array>

namespace tremolo::materials {

/// Principal stresses s1 >= s2 >= s3, Pa, tension positive.
using Principal = std::array<double, 3>;

/// The strength that a point has now.
struct Strength {
  double cohesive = 0.0;     ///< 2 c cos(phi), Pa
  double sin_friction = 0.0; ///< sin(phi)
  double sin_dilation = 0.0; ///< sin(psi)
  double apex = 0.0;         ///< c cot(phi), Pa; infinite for phi = 0
  double tension = 0.0;      ///< largest tensile stress, Pa: the cut-off, at most the apex
};

/// f13, Pa: positive outside the surface.
inline double yield_function(double s1, double s3, const Strength& strength) {
  return (s1 - s3) + (s1 + s3) * strength.sin_friction - strength.cohesive;
}

/// The stress on the surface that belongs to a trial stress outside it, for a strength that does not change.
Principal return_to_surface(const Principal& trial, const Strength& strength, const Elasticity& elastic);

} // namespace tremolo::materials
