#pragma once

// The return to the main plane of the Mohr-Coulomb pyramid, implicit in the plastic strain, for many points
// at once without a branch. On this plane, with trial stress s1 >= s2 >= s3 and S the strength at e + x,
//
//     lambda = f(s1, s3, S)/a,   a = 4 G (1 + sin(phi) sin(psi)/3) + 4 K sin(phi) sin(psi),
//     x = k lambda,              k = 2/sqrt(3) sqrt(1 + sin^2(psi)/3),
//
// solved by two steps of Newton's method. Most points that yield end here; the others - edges, apex, tension
// cut-off, steps so large that x has not converged - are left to implicit_return().

#include "materials/mohr_coulomb.hpp"

#include <array>
#include <cstddef>

namespace tremolo::materials {

/// Stresses (Pa) and plastic strain of some points: the trial before, the end of the step after.
struct PlasticPoints {
  static constexpr std::size_t capacity = 256;
  std::size_t count = 0;
  std::array<double, capacity> sxx;
  std::array<double, capacity> syy;
  std::array<double, capacity> szz;
  std::array<double, capacity> sxy;
  std::array<double, capacity> plastic_strain;
  std::array<double, capacity>
      left; ///< after: not 0 for a point that the main plane does not take, unchanged
};

/// Brings the points that belong there to the main plane; points inside the surface stay as they are.
void return_to_main_plane(const MohrCoulomb& law, PlasticPoints& points);

} // namespace tremolo::materials
