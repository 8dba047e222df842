#pragma once

// Strain of an element over a step, from the motion of its nodes:
//
//     d exx = -s M dv_x,    d eyy = dt D v_y,    d gxy = dt D v_x - s M dv_y,
//     d theta = d exx + d eyy + dt D q_y - s M dq_x,    D a = (a_upper - a_lower)/h,    M a = (a_lower +
//     a_upper)/2,
//
// D of velocities half a step ahead, dv and dq over the whole step, q = n_I w the flux of water.

#include "freefield/twophase/wet_grid.hpp"

namespace tremolo::freefield {

/// Motion of one node in one step.
struct NodeMove {
  double vx = 0.0, vy = 0.0, qy = 0.0;    ///< half a step ahead, m/s
  double dvx = 0.0, dvy = 0.0, dqx = 0.0; ///< change over the step, m/s
};

struct ElementStrain {
  double exx = 0.0, eyy = 0.0, gxy = 0.0;
  double theta = 0.0; ///< dilation of the water's space: of the soil, and by water that flows out
};

inline ElementStrain strain_of(const WetElement& element, const NodeMove& lower, const NodeMove& upper,
                               double slowness, double dt) {
  const double d = dt / element.length;
  const double m = 0.5 * slowness;
  ElementStrain strain{.exx = -m * (lower.dvx + upper.dvx),
                       .eyy = d * (upper.vy - lower.vy),
                       .gxy = d * (upper.vx - lower.vx) - m * (lower.dvy + upper.dvy)};
  strain.theta = strain.exx + strain.eyy;
  if (element.flows())
    strain.theta += d * (upper.qy - lower.qy) - m * (lower.dqx + upper.dqx);
  return strain;
}

} // namespace tremolo::freefield
