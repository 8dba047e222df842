#pragma once

// One component of the velocities of solid and fluid at a node, from t - dt/2 to t + dt/2. With the force F
// on grains and water together and F~ on the unit of fluid volume at t,
//
//     m_s a_s + m_f a_f = F - C v,        v the mean velocity of both, C the dashpots; F holds what moves
//     them, m~_f a_f = F~ - d w,                w = v_f - v_s.
//
// Drag is implicit: with a* = F~/m~_f, b = (1 + m_f/m_s) a* - F/m_s and lambda = (d/m~_f)(1 + m_f/m_s),
//
//     w' = (w + dt b)/(1 + lambda dt),    a_s = (F - m_f (w' - w)/dt)/(m_s + m_f),    a_f = a_s + (w' -
//     w)/dt:
//
// no permeability limits the step, steady flow is exactly Darcy's, and momentum is conserved to rounding.

#include "freefield/twophase/wet_grid.hpp"

namespace tremolo::freefield {

/// Solid and fluid: velocities, m/s.
struct Phases {
  double solid = 0.0;
  double fluid = 0.0;
};

/// F and F~, Pa.
struct NodeForce {
  double mixture = 0.0;
  double fluid = 0.0;
};

/// Grains and water as one mass.
inline Phases kicked_together(const WetNode& node, const Phases& v, double force, double dashpot, double dt) {
  const double velocity = v.solid + dt * (force - dashpot * v.solid) / (node.mass() + 0.5 * dt * dashpot);
  return {velocity, velocity};
}

/// Water flows through the grains.
inline Phases kicked_apart(const WetNode& node, const Phases& v, const NodeForce& force, double dashpot,
                           double dt) {
  const double mass = node.mass();
  const double mean = (node.solid * v.solid + node.fluid * v.fluid) / mass;
  const double mixture = (force.mixture - dashpot * mean) * mass / (mass + 0.5 * dt * dashpot);
  const double ratio = 1.0 + node.fluid / node.solid;
  const double w0 = v.fluid - v.solid;
  const double b = ratio * force.fluid / node.full - mixture / node.solid;
  const double w1 = (w0 + dt * b) / (1.0 + dt * ratio * node.drag / node.full);
  const double solid = v.solid + (dt * mixture - node.fluid * (w1 - w0)) / mass;
  return {solid, solid + w1};
}

/// Water flows over grains that move as prescribed.
inline Phases kicked_by_base(const WetNode& node, const Phases& v, double solid, double fluid_force,
                             double dt) {
  const double w = v.fluid - v.solid + dt * fluid_force / node.full - (solid - v.solid);
  return {solid, solid + w / (1.0 + dt * node.drag / node.full)};
}

} // namespace tremolo::freefield
