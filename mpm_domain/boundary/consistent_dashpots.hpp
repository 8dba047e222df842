#pragma once

// The half step of the boundary dashpots that belongs to the unknown velocities. With the faces' own weights,
//
//     (M + dt/2 C) a = f,      C = sum_f L_f Z_f W_f W_f^T,      f holds -C v- in full,
//
// dashpots act on -C (v- + v+)/2 and nothing else, and a free field of the domain's own discretisation passes
// them unnoticed. The grid update lumps C to the nodes, C_L >= C. The difference goes to its right-hand side,
// found by three fixed-point steps from g_0 = 0:
//
//     (M + dt/2 C_L) a_k = f + g_k,      g_k+1 = dt/2 (C_L - C) a_k.
//
// The iteration's matrix has all its eigenvalues in [0, 1), of the order of (k h)^2 for motion that is smooth
// along the boundary: what the lumping did to it is gone, while a node that has lost nearly all its soil
// stays bound to its C_L.

#include "mpm_domain/boundary/face_nodes.hpp"
#include "mpm_domain/grid/grid.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The consistent dashpots of all faces, or of those that take a step of the same length.
class ConsistentDashpots {
public:
  /// @param nodes that the faces touch; outlives this
  explicit ConsistentDashpots(const FaceNodes& nodes) : nodes_(&nodes) {}

  /// Makes room for a grid of so many nodes.
  void fit(std::size_t grid_size);

  /// Adds g to the nodal forces; the faces' tractions and lumped dashpots are there already.
  /// @param which   the faces that are worked out, as indices
  /// @param weights one a face; a face without any is left out
  /// @param dt time that the forces act for, s
  void correct(Ground& ground, std::span<const BoundaryFace> faces, std::span<const std::size_t> which,
               std::span<const FaceWeights> weights, double dt);

  /// g of a node that faces touch, N/m.
  Vector force_on(std::size_t node) const { return {x_.g[node], y_.g[node]}; }

private:
  /// A component: nothing couples one with the other.
  struct Component {
    NodeField a, g, per_inertia;
    std::vector<double> of_faces;
  };

  void find_inertia(const Grid& grid, const NodeField& dashpot, double empty, double dt, Component& c) const;
  void iterate(const NodeField& force, std::span<const std::size_t> which,
               std::span<const FaceWeights> weights, std::span<const double> dashpots, Component& c) const;

  const FaceNodes* nodes_;
  Component x_, y_;
};

} // namespace tremolo::mpm_domain
