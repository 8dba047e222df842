#pragma once

#include "freefield/column.hpp"
#include "freefield/fe/fe_soil.hpp"
#include "freefield/marched/marched_node.hpp"
#include "freefield/twophase/wet_grid.hpp"

#include <Eigen/Core>

#include <vector>

namespace tremolo::freefield {

/// A marched column at one time.
struct MarchedState {
  WetGrid grid;
  SoilState soil;
  std::vector<ElementStress> stress;  ///< over the state at rest; the pressure not below cavitation
  std::vector<double> excess;         ///< pore pressure, below cavitation too, Pa
  std::vector<NodeMomenta> momenta;   ///< half a step ahead, before drag
  std::vector<NodeVelocity> velocity; ///< at the present time

  MarchedState(WetGrid made, const FeSoil& soil_at_rest)
      : grid(std::move(made)), soil(soil_at_rest.initial()), stress(grid.elements.size()),
        excess(grid.elements.size()), momenta(grid.nodes.size()), velocity(grid.nodes.size()) {}
};

/// What does not change in a march.
struct MarchedScheme {
  double slowness = 0.0; ///< s, s/m
  double dt = 0.0;       ///< s
  BaseKind base = BaseKind::compliant;
  std::vector<Eigen::Matrix2d> dashpots; ///< D of each node, Pa s/m

  bool held(std::size_t node) const { return node == 0 && base == BaseKind::rigid; }
};

/// What comes in at the base in a step.
struct BaseDrive {
  Eigen::Vector2d half = Eigen::Vector2d::Zero();     ///< velocity of a rigid base half a step ahead, m/s
  Eigen::Vector2d whole = Eigen::Vector2d::Zero();    ///< and at the end of the step
  Eigen::Vector2d traction = Eigen::Vector2d::Zero(); ///< B v_inc at the end of the step, Pa
  /// v_ref of mass-proportional damping at the end of the step (base_motion.hpp), m/s
  Eigen::Vector2d reference = Eigen::Vector2d::Zero();
};

} // namespace tremolo::freefield
