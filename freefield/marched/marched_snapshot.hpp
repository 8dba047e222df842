#pragma once

#include "freefield/column.hpp"
#include "freefield/column_mesh.hpp"
#include "freefield/marched/marched_node.hpp"
#include "freefield/twophase/wet_grid.hpp"

#include <Eigen/Core>

#include <vector>

namespace tremolo::freefield {

/// A marched column at one time: what it takes to give motion, stress and pore pressure anywhere in it.
struct MarchedSnapshot {
  double slowness = 0.0; ///< s/m
  // Values at the nodes.
  std::vector<Eigen::Vector2d> u;     ///< displacement of the grains, m
  std::vector<NodeVelocity> velocity; ///< m/s
  std::vector<Eigen::Vector2d> force; ///< F with what acts from outside, Pa: rate of P
  std::vector<double> fluid_force;    ///< F~, Pa; of a sealed node what its grains ask of the water there
  // Values at the centres of the elements.
  std::vector<ElementStress> stress; ///< over the state at rest, Pa, small-strain damping included
  std::vector<double> modulus;       ///< M, Pa

  /// Velocities, stresses, pressure, displacements and strains at a place; no rates.
  ColumnSample at(const ColumnMesh& mesh, const WetGrid& grid, const ColumnMesh::Place& place) const;

private:
  double lateral_by_motion(const WetElement& element, double p_modulus, double vx) const;
};

} // namespace tremolo::freefield
