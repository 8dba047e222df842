#pragma once

// A node in a column whose fields depend on t - s x. Grains move with v, water with v + w; S = sigma' - p is
// total stress, N(a) the sum of a h/2 over the elements beside the node. The momenta
//
//     P = m_s v + m_f (v + w) + s N(Sxx, sxy),    R = m~_f (v + w) - (s N(p), 0)
//
// grow by the forces F and F~ alone, R by drag as well. With G = m v + m_f w, m = m_s + m_f, either level of
// a step is
//
//     G = (1 + tau D/m)^-1 (P + tau (F + b) - s N(S)),
//     w = (R + (s N(p), 0) + tau F~ - m~_f G/m) / (m~_f m_s/m + kappa d),    v = (G - m_f w)/m,
//
// with tau = 0, kappa = dt half a step ahead, and tau = kappa = dt/2 at its end. b and D v are what dashpots
// at the node bring and take, v being the mean velocity of both phases. A node without water, or whose water
// cannot pass, has w = 0 in the direction concerned.

#include "freefield/twophase/wet_grid.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

namespace tremolo::freefield {

/// Stress of one element over the state at rest, Pa: effective, and excess pore pressure.
struct ElementStress {
  double xx = 0.0, yy = 0.0, xy = 0.0, pressure = 0.0;
};

/// What the stress of the elements beside a node does to it, Pa or, times a slowness, Pa s.
struct NodeLoad {
  Eigen::Vector2d lateral = Eigen::Vector2d::Zero(); ///< s N(Sxx, sxy)
  double lateral_pressure = 0.0;                     ///< s N(p) of elements in which water flows
  Eigen::Vector2d force = Eigen::Vector2d::Zero();   ///< F
  double fluid_force = 0.0;                          ///< F~, vertical

  /// Adds an element that lies above (+1) or below (-1) the node.
  void add(const WetElement& element, const ElementStress& stress, double slowness, double side) {
    const double share = 0.5 * slowness * element.length;
    lateral += share * Eigen::Vector2d(stress.xx - stress.pressure, stress.xy);
    force += side * Eigen::Vector2d(stress.xy, stress.yy - stress.pressure);
    if (element.flows()) {
      lateral_pressure += share * stress.pressure;
      fluid_force -= side * stress.pressure;
    }
  }

  NodeLoad& add(double factor, const NodeLoad& other) {
    lateral += factor * other.lateral;
    lateral_pressure += factor * other.lateral_pressure;
    force += factor * other.force;
    fluid_force += factor * other.fluid_force;
    return *this;
  }
};

/// Grains, and water relative to them, m/s.
struct NodeVelocity {
  Eigen::Vector2d solid = Eigen::Vector2d::Zero();
  Eigen::Vector2d relative = Eigen::Vector2d::Zero(); ///< w

  Eigen::Vector2d mean(const WetNode& node) const { return solid + node.fluid / node.mass() * relative; }
};

/// P and R, kg/(m s).
struct NodeMomenta {
  Eigen::Vector2d mixture = Eigen::Vector2d::Zero();
  Eigen::Vector2d fluid = Eigen::Vector2d::Zero();
};

/// Velocities from G of a free node.
/// @param fluid  R with what acts on the water
/// @param drag_time  kappa, s
inline NodeVelocity split(const WetNode& node, const Eigen::Vector2d& mixture, const Eigen::Vector2d& fluid,
                          double drag_time) {
  NodeVelocity v{mixture / node.mass()};
  if (node.fluid == 0.0)
    return v;
  const double inertia = node.full * node.solid / node.mass() + drag_time * node.drag;
  v.relative.x() = (fluid.x() - node.full * v.solid.x()) / inertia;
  v.relative.y() = node.sealed ? 0.0 : (fluid.y() - node.full * v.solid.y()) / inertia;
  v.solid -= node.fluid / node.mass() * v.relative;
  return v;
}

/// Velocities where the grains move as prescribed.
inline NodeVelocity split_held(const WetNode& node, const Eigen::Vector2d& solid,
                               const Eigen::Vector2d& fluid, double drag_time) {
  NodeVelocity v{solid};
  if (node.fluid == 0.0)
    return v;
  const double inertia = node.full + drag_time * node.drag;
  v.relative.x() = (fluid.x() - node.full * solid.x()) / inertia;
  v.relative.y() = node.sealed ? 0.0 : (fluid.y() - node.full * solid.y()) / inertia;
  return v;
}

} // namespace tremolo::freefield
