#pragma once

// The return to the main plane of the Mohr-Coulomb pyramid, implicit in the plastic strain, for many points
// at once without a branch. On this plane, with trial stress s1 >= s2 >= s3 and S the strength at e + x,
//
//     lambda = f(s1, s3, S)/a,   a = 4 G (1 + sin(phi) sin(psi)/3) + 4 K sin(phi) sin(psi),
//     x = k lambda,              k = 2/sqrt(3) sqrt(1 + sin^2(psi)/3),
//
// solved by two steps of Newton's method. Most points that yield end here; the others - edges, apex, tension
// cut-off, steps so large that x has not converged - are left to implicit_return().

#include "materials/elastic/elastic_trial.hpp"
#include "materials/law/points.hpp"
#include "materials/plastic/mohr_coulomb.hpp"

#include <array>
#include <cstddef>

namespace tremolo::materials {

/// Stresses (Pa) and plastic strain of some points: the trial before, the end of the step after.
struct PlasticPoints {
  static constexpr std::size_t capacity = 256;
  using Lane = std::array<double, capacity>;
  std::size_t count = 0;
  Lane sxx, syy, szz, sxy;
  Lane plastic_strain;
  Lane dexx, deyy, dezz, dgxy; ///< strain increments of the step
  Lane plastic_work;           ///< after: of the step, J/m3
  Lane left;                   ///< after: not 0 for a point that the main plane does not take, unchanged

  /// Point i of others becomes point k of these.
  void take(const Points& points, std::size_t i, std::size_t k) {
    sxx[k] = points.sxx[i];
    syy[k] = points.syy[i];
    szz[k] = points.szz[i];
    sxy[k] = points.sxy[i];
    plastic_strain[k] = points.state[i];
    dexx[k] = points.dexx[i];
    deyy[k] = points.deyy[i];
    dezz[k] = out_of_plane_strain(points, i);
    dgxy[k] = points.dgxy[i];
  }

  /// Point k of these is given back its place among the others.
  void give(const Points& points, std::size_t i, std::size_t k) const {
    points.sxx[i] = sxx[k];
    points.syy[i] = syy[k];
    points.szz[i] = szz[k];
    points.sxy[i] = sxy[k];
    points.state[i] = plastic_strain[k];
    points.plastic_work[i] += plastic_work[k];
  }
};

/// Brings the points that belong there to the main plane; points inside the surface stay as they are.
void return_to_main_plane(const MohrCoulomb& law, PlasticPoints& points);

} // namespace tremolo::materials
