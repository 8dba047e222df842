#pragma once

#include "freefield/twophase/wet_grid.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// Values of grains and water at the nodes, from the base up, in columns: vx, vy, wx, wy, and as G and R.
using NodeFields = Eigen::Array<double, Eigen::Dynamic, 4>;

/// Masses and drag of the nodes, in arrays.
struct NodeMasses {
  Eigen::ArrayXd solid, fluid, full, drag, mass; ///< m_s, m_f, m~_f, kg/m2, d, Pa s/m, and m
  Eigen::ArrayXd passes;                         ///< 1 where water can pass up or down, else 0
  Eigen::ArrayXd mass_damping;                   ///< Pa s/m

  void gather(const std::vector<WetNode>& nodes);
};

/// Splits G and R of the nodes, R including the forces on the water, into v and w (marched_node.hpp). Where
/// grains are held, their velocity replaces G.
class NodeSplit {
public:
  /// @param drag_time  kappa, s
  /// @param brake_time  tau of mass-proportional damping, s; that of the base node is left to its impedance
  void set(const NodeMasses& nodes, double drag_time, double brake_time, bool base_held);

  void operator()(const NodeFields& momenta, NodeFields& velocity) const;
  Eigen::Vector4d at(std::size_t node, const Eigen::Vector4d& momenta) const;

private:
  NodeFields own_, other_; ///< what v and w take of G and R, and of R and G
  Eigen::ArrayXd per_mass_, share_, mobility_;
};

} // namespace tremolo::freefield
