#pragma once

#include "coupler/eq6/boundary_traction.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::mpm_domain {

/// Four doubles that are loaded, multiplied and stored together: a node's record is one or two of them.
using Lanes = double __attribute__((vector_size(32)));

/// What particles and faces add up at a node in one step.
struct NodeSum {
  Lanes motion; ///< mass (kg/m), momentum x, y (kg/s), unused
  Lanes force;  ///< force x, y (N/m); boundary dashpots lumped to the node x, y (Pa s)
};

/// Velocities of a node in one step, m/s.
struct NodeMotion {
  Lanes velocity; ///< before the update (or remapped after it) x, y; after the update x, y
};

/// The uniform background grid. Node (i, j) lies at (x0 + i h, y0 + j h).
struct Grid {
  double h = 0.0;
  double x0 = 0.0;
  double y0 = 0.0;
  int nx = 0; ///< nodes per row
  int ny = 0; ///< rows
  std::vector<NodeSum> sums;
  std::vector<NodeMotion> motion;
  std::vector<eq6::Vector> acceleration; ///< of the last update, m/s2

  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
  }
  std::size_t size() const { return sums.size(); }
};

} // namespace tremolo::mpm_domain
