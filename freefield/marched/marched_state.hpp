#pragma once

#include "freefield/column.hpp"
#include "freefield/column_relaxation.hpp"
#include "freefield/column_soil.hpp"
#include "freefield/marched/element_strain.hpp"
#include "freefield/marched/marched_node.hpp"
#include "freefield/marched/node_split.hpp"
#include "freefield/twophase/wet_grid.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace tremolo::freefield {

/// Values of the elements, from the base up, in columns: effective sxx, syy, sxy and pore pressure, or exx,
/// eyy, gxy and theta.
using ElementFields = Eigen::Array<double, Eigen::Dynamic, 4>;
/// Effective sxx, syy and sxy of the elements, Pa.
using PlaneFields = Eigen::Array<double, Eigen::Dynamic, 3>;
/// Increments of stress over a step, Pa.
using Increments = ElementFields;

/// A marched column at one time.
struct MarchedState {
  WetGrid grid;
  SoilState soil;
  std::vector<ElementStress> stress;  ///< over the state at rest; the pressure not below cavitation
  std::vector<double> excess;         ///< pore pressure, below cavitation too, Pa
  std::vector<NodeMomenta> momenta;   ///< half a step ahead, before drag
  std::vector<NodeVelocity> velocity; ///< at the present time
  /// Strain of the elements that their laws have not yet followed. It counts as elastic, in `stress` and not
  /// in `soil`, until the next step.
  ElementFields owed;
  PlaneFields law_stress;      ///< the part of `stress` that is not of relaxation mechanisms
  ColumnRelaxation relaxation; ///< the other part

  MarchedState(WetGrid made, const ColumnSoil& soil_at_rest, ColumnRelaxation unstressed)
      : grid(std::move(made)), soil(soil_at_rest.initial()), stress(grid.elements.size()),
        excess(grid.elements.size()), momenta(grid.nodes.size()), velocity(grid.nodes.size()),
        owed(ElementFields::Zero(std::ssize(grid.elements), 4)),
        law_stress(PlaneFields::Zero(std::ssize(grid.elements), 3)), relaxation(std::move(unstressed)) {}
};

/// Constants of a march.
struct MarchedScheme {
  double slowness = 0.0; ///< s, s/m
  double dt = 0.0;       ///< s
  BaseKind base = BaseKind::compliant;
  Eigen::Matrix2d half_space = Eigen::Matrix2d::Zero(); ///< Z below a compliant base, Pa s/m

  bool held(std::size_t node) const { return node == 0 && base == BaseKind::rigid; }
  /// (1 + dt/2 D/m)^-1 of the base node, D its dashpots of both kinds.
  Eigen::Matrix2d braked(const WetNode& base_node) const {
    const Eigen::Matrix2d all = half_space + base_node.mass_damping * Eigen::Matrix2d::Identity();
    return (Eigen::Matrix2d::Identity() + 0.5 * dt / base_node.mass() * all).inverse();
  }
  /// The vector from which the base node is split at the end of a step: G, or the velocity of a rigid base.
  Eigen::Vector2d at_base(const Eigen::Vector2d& momentum, const Eigen::Matrix2d& brake,
                          const Eigen::Vector2d& prescribed) const {
    return held(0) ? prescribed : Eigen::Vector2d(brake * momentum);
  }
  /// Splits the motion of the nodes half a step ahead, and at the end of the step.
  void set_half(NodeSplit& split, const NodeMasses& nodes) const { split.set(nodes, dt, 0.0, held(0)); }
  void set_whole(NodeSplit& split, const NodeMasses& nodes) const {
    split.set(nodes, 0.5 * dt, 0.5 * dt, held(0));
  }
};

/// Input at the base in a step.
struct BaseDrive {
  Eigen::Vector2d half = Eigen::Vector2d::Zero();     ///< velocity of a rigid base half a step ahead, m/s
  Eigen::Vector2d whole = Eigen::Vector2d::Zero();    ///< and at the end of the step
  Eigen::Vector2d traction = Eigen::Vector2d::Zero(); ///< B v_inc at the end of the step, Pa
  /// v_ref of mass-proportional damping at the end of the step (base_motion.hpp), m/s
  Eigen::Vector2d reference = Eigen::Vector2d::Zero();
};

} // namespace tremolo::freefield
