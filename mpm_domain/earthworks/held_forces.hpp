#pragma once

// Forces on nodes that make up for a change of the particles, and go to zero along half of a cosine. With
// mass and force of a node before the change, m0 and f0, and after it, m1 and f1,
//
//     c = min(1, m1/m0) f0 - f1,
//
// so that the node goes on as it did: with the force that it had while it has as much mass, and with the
// acceleration that it had where it has less. A node that is left with next to nothing would be thrown by
// what a heavier one had.
//
// Nodes are known by level and by how many cells they lie from the lower left corner of the model, which
// stays when the grid grows.

#include "mpm_domain/ground.hpp"
#include "mpm_domain/ranks/exact_sum.hpp"

#include <array>
#include <map>
#include <vector>

namespace tremolo::mpm_domain {

/// Level, and cells to the right of and above the corner of the model.
using PositionInModel = std::array<int, 3>;

/// Force and mass that the particles give to a node.
struct NodeLoad {
  double mass = 0.0; ///< kg/m
  Vector force;      ///< weight included, N/m
};

/// The loads of the nodes with mass that count on this rank. Particles must be in the order of their present
/// positions.
std::map<PositionInModel, NodeLoad> node_loads(Ground& ground);

class HeldForces {
public:
  HeldForces() = default;
  /// @param before,after  on this rank
  /// @param ranks         that all have such loads, of nodes that may have changed hands in between, and all
  ///                      take the forces of all nodes; null: there is one process
  HeldForces(const std::map<PositionInModel, NodeLoad>& before,
             const std::map<PositionInModel, NodeLoad>& after, Communicator* ranks);

  /// Adds a share (1) of the forces to those of the nodes.
  void act(Ground& ground, double share) const;
  /// Power of that share on the mean of velocities before and after the last update, W/m, at the nodes that
  /// count on this rank.
  ExactSums<1> power(const Ground& ground, double share) const;
  /// Power of that share on what the velocity that strains the soil differs by from that after the update,
  /// W/m, at these nodes.
  ExactSums<1> remap_power(const Ground& ground, double share) const;

  /// State for a checkpoint, and its restoration.
  std::vector<double> state() const;
  void set_state(const std::vector<double>& state);

private:
  template <class Act>
  void over_nodes(const Ground& ground, double share, const Act& act) const;
  template <class PowerOn>
  ExactSums<1> sum_over_nodes(const Ground& ground, double share, const PowerOn& power_on) const;

  std::map<PositionInModel, Vector> forces_; ///< c, N/m
};

} // namespace tremolo::mpm_domain
