#pragma once

// Boxes that follow the soil. A particle's square of half side l becomes a parallelogram with the second
// moments M/3,
//
//     M = l^2 F F^T,      M <- (I + dt L) M (I + dt L)^T
//
// in a step dt, L the velocity gradient: F of all steps together is that by which an affine velocity has
// moved the particles. The axis-parallel box of the same moments about x and y has the half sides
//
//     l_x = sqrt(M_xx),    l_y = sqrt(M_yy).
//
// Where soil is stretched along the axes these boxes go on tiling it, as those of contiguous-particle GIMP do
// (Bardenhagen and Kober 2004; Wallstedt and Guilkey 2008); soil that turns as a whole keeps its boxes.
//
// A box is never wider than two cells, so that four nodes a direction hold it: the domain scaling of Homel,
// Brannon and Guilkey (2015), "Controlling the onset of numerical fracture in parallelized implementations of
// the material point method (MPM) with convective particle domain interpolation (CPDI) domain scaling". Nor
// is it narrower than a quarter of a cell: a node that boxes of half side l just begin to touch at a free
// edge has the mass rho low^2/(4l) and the stiffness rho c^2 low^2/(4l^2 h), so it bears steps up to 2 sqrt(l
// h)/c, which for l < 0.11 h are shorter than those that all else bears.

#include "mpm_domain/kernel/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

/// M of one particle, or of four, m2.
template <typename Real>
struct BoxMoments {
  Real xx{}, xy{}, yy{};
};

/// An increment of displacement, dt L.
template <typename Real>
struct DisplacementGradient {
  Real xx{}, xy{}, yx{}, yy{}; ///< d u_a / d x_b
};

template <typename Real>
BoxMoments<Real> deformed(const BoxMoments<Real>& m, const DisplacementGradient<Real>& du) {
  const Real fxx = 1.0 + du.xx;
  const Real fyy = 1.0 + du.yy;
  const Real x_mx = fxx * m.xx + du.xy * m.xy; // (F M)_xx and so on
  const Real x_my = fxx * m.xy + du.xy * m.yy;
  const Real y_mx = du.yx * m.xx + fyy * m.xy;
  const Real y_my = du.yx * m.xy + fyy * m.yy;
  return {x_mx * fxx + x_my * du.xy, x_mx * du.yx + x_my * fyy, y_mx * du.yx + y_my * fyy};
}

/// Between which half sides boxes stay, m.
struct BoxLimits {
  /// @param h  size of the cells that the particles belong to, m
  explicit BoxLimits(double h) : least(0.125 * h), most(h) {}

  double half_side(double moment) const { return std::clamp(std::sqrt(moment), least, most); }
  Lanes half_side(const Lanes& moment) const { return clamp(sqrt(moment), least, most); }

  double least;
  double most;
};

} // namespace tremolo::mpm_domain
