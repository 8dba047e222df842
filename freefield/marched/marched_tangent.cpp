// The increment X of an element moves its two nodes, and these strain their elements: with C the elastic
// stiffness, and -K_f/n for the water,
//
//     J = 1 - C (d strain/d move) (d move/d X),
//
// block tridiagonal, J dX = residual. The small-strain damping is left out.

#include "freefield/marched/marched_tangent.hpp"

#include "freefield/marched/element_strain.hpp"

namespace tremolo::freefield {
namespace {

using Eigen::Vector2d;
using Strain = Eigen::Vector4d;
using Move = Eigen::Vector<double, 6>;
using MoveByStress = Eigen::Matrix<double, 6, 4>;
using StrainByMove = Eigen::Matrix<double, 4, 6>;

NodeMove move_of(const Move& m) {
  return {m[0], m[1], m[2], m[3], m[4], m[5]};
}

/// How a unit of each increment of an element moves one of its nodes.
MoveByStress move_by_stress(const MarchedScheme& scheme, const WetGrid& grid, std::size_t i, std::size_t e) {
  const WetNode& node = grid.nodes[i];
  const double dt = scheme.dt;
  const Eigen::Matrix2d implicit =
      (Eigen::Matrix2d::Identity() + 0.5 * dt / node.mass() * scheme.dashpots[i]).inverse();
  const auto velocity = [&](const Vector2d& mixture, const Vector2d& fluid, double drag_time) {
    return scheme.held(i) ? split_held(node, Vector2d::Zero(), fluid, drag_time)
                          : split(node, mixture, fluid, drag_time);
  };
  MoveByStress moves;
  for (Eigen::Index k = 0; k < 4; ++k) {
    const Eigen::Vector4d unit = Eigen::Vector4d::Unit(k);
    NodeLoad load;
    load.add(grid.elements[e], {unit[0], unit[1], unit[2], unit[3]}, scheme.slowness, e == i ? 1.0 : -1.0);
    const NodeVelocity half = velocity(-0.5 * load.lateral, {0.5 * load.lateral_pressure, 0.0}, dt);
    const Vector2d fluid =
        Vector2d(load.lateral_pressure, 0.5 * dt * load.fluid_force) - dt * node.drag * half.relative;
    const NodeVelocity whole = velocity(implicit * (0.5 * dt * load.force - load.lateral), fluid, 0.5 * dt);
    moves.col(k) << half.solid, node.porosity() * half.relative.y(), whole.solid,
        node.porosity() * whole.relative.x();
  }
  return moves;
}

/// How a unit of each motion of its lower or upper node strains an element.
StrainByMove strain_by_move(const MarchedScheme& scheme, const WetElement& element, bool lower) {
  StrainByMove strains;
  for (Eigen::Index k = 0; k < 6; ++k) {
    const NodeMove unit = move_of(Move::Unit(k));
    const ElementStrain strain = lower ? strain_of(element, unit, {}, scheme.slowness, scheme.dt)
                                       : strain_of(element, {}, unit, scheme.slowness, scheme.dt);
    strains.col(k) = Strain(strain.exx, strain.eyy, strain.gxy, strain.theta);
  }
  return strains;
}

Eigen::Matrix4d stiffness(const WetElement& element, double modulus) {
  const double lateral = element.lateral_ratio * modulus;
  Eigen::Matrix4d c = Eigen::Matrix4d::Zero();
  c.topLeftCorner<2, 2>() << modulus, lateral, lateral, modulus;
  c(2, 2) = element.shear_ratio * modulus;
  c(3, 3) = -element.stiffness;
  return c;
}

} // namespace

void MarchedTangent::factor(const MarchedScheme& scheme, const WetGrid& grid,
                            const std::vector<double>& moduli) {
  const std::size_t n = grid.elements.size();
  for (std::size_t e = 0; e < n; ++e) {
    const Eigen::Matrix4d c = stiffness(grid.elements[e], moduli[e]);
    const Eigen::Matrix<double, 4, 6> below = c * strain_by_move(scheme, grid.elements[e], true);
    const Eigen::Matrix<double, 4, 6> above = c * strain_by_move(scheme, grid.elements[e], false);
    matrix_.diagonal(e) = Eigen::Matrix4d::Identity() - below * move_by_stress(scheme, grid, e, e) -
                          above * move_by_stress(scheme, grid, e + 1, e);
    if (e > 0)
      matrix_.lower(e - 1) = -below * move_by_stress(scheme, grid, e, e - 1);
    if (e + 1 < n)
      matrix_.upper(e) = -above * move_by_stress(scheme, grid, e + 1, e + 1);
  }
  matrix_.factor();
}

} // namespace tremolo::freefield
