#pragma once

// The mesh of the ground that water flows through (seepage_of_ground.hpp): its cells, and its edges by what
// they border on.

#include "mpm_domain/head/head.hpp"
#include "mpm_domain/spec/spec.hpp"
#include "seepage/flow_problem.hpp"

#include <vector>

namespace tremolo::mpm_domain {

struct GroundMesh {
  /// Nodes of the regular grid, some of them moved onto the surface; elements with their permeability. No
  /// conditions yet.
  seepage::FlowProblem problem;
  HeadGrid grid; ///< the regular grid, without heads
  /// Level of the ground to the left and to the right of each column of nodes, m; the base where there is no
  /// ground.
  std::vector<double> left_of, right_of;
  std::vector<std::size_t> left, right; ///< nodes of both sides of the model
  std::vector<std::size_t> surface;     ///< nodes that are open to the air, or to free water

  double ground(std::size_t column) const { return std::max(left_of[column], right_of[column]); }
  /// Levels as near as this are one, m.
  double slack() const { return 1e-5 * grid.h; }
  std::size_t column(std::size_t node) const { return node % grid.columns; }
};

/// The highest edge of the regions at x (m), within the model; its base where there is none.
double ground_at(const Spec& spec, double x);

/// @throws std::invalid_argument for a soil without permeability, which it names
GroundMesh mesh_of(const Spec& spec);

} // namespace tremolo::mpm_domain
