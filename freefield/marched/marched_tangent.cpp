// The increment X of an element moves its two nodes, and these strain their elements: with C the elastic
// stiffness, and -K_f/n for the water,
//
//     J = 1 - C (d strain/d move) (d move/d X),
//
// block tridiagonal, J dX = residual. Viscous damping is left out.

#include "freefield/marched/marched_tangent.hpp"

#include "freefield/marched/element_strain.hpp"

#include <cmath>

namespace tremolo::freefield {
namespace {

using Eigen::Vector2d;
using Strain = Eigen::Vector4d;
using Move = Eigen::Vector<double, 6>;
using MoveByStress = Eigen::Matrix<double, 6, 4>;
using StrainByMove = Eigen::Matrix<double, 4, 6>;

/// Motion of one of an element's nodes due to a unit of each increment.
MoveByStress move_by_stress(const MarchedScheme& scheme, const WetGrid& grid, const NodeSplit& half_split,
                            const NodeSplit& whole_split, std::size_t i, std::size_t e) {
  const WetNode& node = grid.nodes[i];
  const double dt = scheme.dt;
  const Eigen::Matrix2d braked = i == 0 ? scheme.braked(node) : Eigen::Matrix2d::Identity();
  MoveByStress moves;
  for (Eigen::Index k = 0; k < 4; ++k) {
    const Eigen::Vector4d unit = Eigen::Vector4d::Unit(k);
    const NodeLoad one(grid.elements[e], {unit[0], unit[1], unit[2], unit[3]}, scheme.slowness);
    const NodeLoad load = e == i ? NodeLoad::between({}, one) : NodeLoad::between(one, {});
    Eigen::Vector4d half = -0.5 * load.lateral;
    if (scheme.held(i))
      half.head<2>().setZero();
    half = half_split.at(i, half);
    Eigen::Vector4d whole = 0.5 * dt * load.force - load.lateral;
    whole.tail<2>() -= dt * node.drag * half.tail<2>(); // drag takes momentum from the water in between
    if (i == 0)
      whole.head<2>() = scheme.at_base(whole.head<2>(), braked, Vector2d::Zero());
    whole = whole_split.at(i, whole);
    moves.col(k) << half[0], half[1], node.porosity() * half[3], whole[0], whole[1],
        node.porosity() * whole[2];
  }
  return moves;
}

/// Strain of an element due to a unit of each motion of its lower or upper node.
StrainByMove strain_by_move(const MarchedScheme& scheme, const WetElement& element, bool lower) {
  StrainByMove strains;
  for (Eigen::Index k = 0; k < 6; ++k) {
    const Move unit = Move::Unit(k);
    const Eigen::Vector4d half(unit[0], unit[1], 0.0, unit[2]), change(unit[3], unit[4], unit[5], 0.0);
    const ElementStrain strain = strain_of(element, lower ? -half : half, change, scheme.slowness, scheme.dt);
    strains.col(k) = Strain(strain.exx, strain.eyy, strain.gxy, strain.theta);
  }
  return strains;
}

/// The stiffness over a step of law, relaxation mechanisms and water together, Pa.
Eigen::Matrix4d stiffness(const WetElement& element, const StiffnessFactors& over_a_step, double modulus) {
  const double shear = over_a_step.shear * element.shear_ratio * modulus;
  const double area = over_a_step.area * (element.lateral_ratio + element.shear_ratio) * modulus;
  Eigen::Matrix4d c = Eigen::Matrix4d::Zero();
  c.topLeftCorner<2, 2>() << area + shear, area - shear, area - shear, area + shear;
  c(2, 2) = shear;
  c(3, 3) = -element.stiffness;
  return c;
}

} // namespace

void MarchedTangent::factor(const MarchedScheme& scheme, const MarchedState& state,
                            const std::vector<double>& moduli) {
  const WetGrid& grid = state.grid;
  const std::size_t n = grid.elements.size();
  modulus_ = moduli;
  length_.resize(n);
  NodeMasses masses;
  masses.gather(grid.nodes);
  NodeSplit half, whole;
  scheme.set_half(half, masses);
  scheme.set_whole(whole, masses);
  const auto moves = [&](std::size_t i, std::size_t e) {
    return move_by_stress(scheme, grid, half, whole, i, e);
  };
  for (std::size_t e = 0; e < n; ++e) {
    length_[e] = grid.elements[e].length;
    const Eigen::Matrix4d c = stiffness(grid.elements[e], state.relaxation.over_a_step(e), moduli[e]);
    const Eigen::Matrix<double, 4, 6> below = c * strain_by_move(scheme, grid.elements[e], true);
    const Eigen::Matrix<double, 4, 6> above = c * strain_by_move(scheme, grid.elements[e], false);
    matrix_.diagonal(e) = Eigen::Matrix4d::Identity() - below * moves(e, e) - above * moves(e + 1, e);
    if (e > 0)
      matrix_.lower(e - 1) = -below * moves(e, e - 1);
    if (e + 1 < n)
      matrix_.upper(e) = -above * moves(e + 1, e + 1);
  }
  matrix_.factor();
}

void MarchedTangent::solve(Increments& residual) {
  blocks_ = residual.transpose();
  matrix_.solve(blocks_.data());
  residual = blocks_.transpose();
}

void MarchedTangent::follow(const MarchedScheme& scheme, const MarchedState& state,
                            const std::vector<double>& moduli) {
  const auto has_left = [](double now, double then) { return std::abs(now - then) > 0.01 * then; };
  for (std::size_t e = 0; e < moduli.size(); ++e)
    if (has_left(moduli[e], modulus_[e]) || has_left(state.grid.elements[e].length, length_[e])) {
      factor(scheme, state, moduli);
      return;
    }
}

} // namespace tremolo::freefield
