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

namespace tremolo::freefield {

/// Stress of one element over the state at rest, Pa: effective, and excess pore pressure.
struct ElementStress {
  double xx = 0.0, yy = 0.0, xy = 0.0, pressure = 0.0;
};

/// Loads on a node from the stress of its elements, in the order of G and R.
struct NodeLoad {
  Eigen::Vector4d lateral = Eigen::Vector4d::Zero(); ///< s N(Sxx, sxy) and (-s N(p), 0), Pa s
  Eigen::Vector4d force = Eigen::Vector4d::Zero();   ///< F and (0, F~), Pa

  NodeLoad() = default;
  /// The load of an element below the node; an element above it pulls the other way.
  NodeLoad(const WetElement& element, const ElementStress& stress, double slowness) {
    const double share = 0.5 * slowness * element.length;
    const double flowing = element.flows() ? stress.pressure : 0.0;
    lateral << share * (stress.xx - stress.pressure), share * stress.xy, -share * flowing, 0.0;
    force << -stress.xy, stress.pressure - stress.yy, 0.0, flowing;
  }

  /// Loads of the elements below and above a node, each made as if it lay below.
  static NodeLoad between(const NodeLoad& below, const NodeLoad& above) {
    NodeLoad load;
    load.lateral = below.lateral + above.lateral;
    load.force = below.force - above.force;
    return load;
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

} // namespace tremolo::freefield
