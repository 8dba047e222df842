#pragma once

// Strain of an element over a step, from the motion of its nodes:
//
//     d exx = -s M dv_x,    d eyy = dt D v_y,    d gxy = dt D v_x - s M dv_y,
//     d theta = d exx + d eyy + dt D q_y - s M dq_x,    D a = (a_upper - a_lower)/h,    M a = (a_lower +
//     a_upper)/2,
//
// D of velocities half a step ahead, dv and dq over the whole step, q = n_I w the flux of water.

#include "freefield/twophase/wet_grid.hpp"

#include <Eigen/Core>

namespace tremolo::freefield {

struct ElementStrain {
  double exx = 0.0, eyy = 0.0, gxy = 0.0;
  double theta = 0.0; ///< dilation of the water's space: of the soil, and by water that flows out
};

/// @param difference  of v and q half a step ahead between the upper and the lower node, (vx, vy, qx, qy),
/// m/s
/// @param changes  of v and q over the step, the sum of those of the nodes, m/s
inline ElementStrain strain_of(const WetElement& element, const Eigen::Vector4d& difference,
                               const Eigen::Vector4d& changes, double slowness, double dt) {
  const Eigen::Vector4d d = dt / element.length * difference;
  const Eigen::Vector4d m = 0.5 * slowness * changes;
  const double expelled = element.flows() ? d[3] - m[2] : 0.0;
  return {.exx = -m[0], .eyy = d[1], .gxy = d[0] - m[1], .theta = d[1] - m[0] + expelled};
}

} // namespace tremolo::freefield
