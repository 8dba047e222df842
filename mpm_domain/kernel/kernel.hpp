#pragma once

// GIMP weights in one direction (Bardenhagen and Kober 2004): the hat function N of the grid averaged over
// the particle's box [x - l, x + l] with l <= h,
//
//     S_i = 1/(2l) int_box N_i dx,      G_i = dS_i/dx.
//
// Take four consecutive nodes 0 to 3, let the particle lie at xi cells above node 1, and measure lengths in
// cells. Where its box crosses no node, S = N(xi) and G = N'(xi). A box that reaches a length `low` below
// node 1 or `high` above node 2 rounds the kink of N there:
//
//     S = (0, 1 - xi, xi, 0) + low^2/(4l) (1, -2, 1, 0) + high^2/(4l) (0, 1, -2, 1),
//     G = 1/h { (0, -1, 1, 0) - low/(2l) (1, -2, 1, 0) + high/(2l) (0, 1, -2, 1) },
//     low = max(0, l - xi),    high = max(0, xi + l - 1),
//
// with the second moment sum_i S_i (x_i - x)^2 = h^2 { xi (1 - xi) + low^2/(2l) + high^2/(2l) }. No branches:
// the formulas hold for one particle (Real = double) and for four at once (Real = Lanes), whose boxes are all
// alike (HalfSide<double>) or not (HalfSide<Lanes>).

#include "mpm_domain/kernel/lanes.hpp"

#include <array>
#include <cmath>

namespace tremolo::mpm_domain {

/// A direction of the grid as the kernel sees it.
struct Axis {
  /// @param origin_  coordinate of node 0, m
  /// @param h_       cell size, m
  Axis(double origin_, double h_) : origin(origin_), h(h_), per_h(1.0 / h_) {}

  /// Place of a coordinate in cells from node 0
  template <typename Real>
  Real cells(Real x) const {
    return (x - origin) * per_h;
  }

  double origin;
  double h;
  double per_h; ///< 1/h, 1/m
};

/// Half the side of boxes in one direction, and what the weights ask of it.
template <typename Real>
struct HalfSide {
  /// @param half_side  of the boxes, m, in (0, h]
  HalfSide(const Real& half_side, const Axis& axis) : HalfSide(half_side * axis.per_h, axis.per_h) {}
  /// @param cells  half side in cells
  /// @param per_h  of the axis, 1/m
  HalfSide(const Real& cells, double per_h) : l(cells), per_4l(0.25 / l), per_2lh(2.0 * per_4l * per_h) {}

  Real l;       ///< in cells
  Real per_4l;  ///< 1/(4 l)
  Real per_2lh; ///< 1/(2 l h), 1/m
};

/// Contributions to S and G at a node of a box that extends beyond it by the length `past`.
template <typename Real>
struct Kink {
  Real s, g;

  template <typename Length>
  Kink(Real past, const HalfSide<Length>& box) : s(box.per_4l * past * past), g(box.per_2lh * past) {}
};

/// S and G of the four nodes around a cell for particles at xi in [0, 1] of it.
template <typename Real>
struct CellWeights {
  std::array<Real, 4> s, g;
  Real second_moment; ///< sum_i S_i (x_i - x)^2, m2: APIC's inertia of the kernel. Never below l^2/3.

  template <typename Length>
  CellWeights(Real xi, const Axis& axis, const HalfSide<Length>& box) {
    const Kink<Real> low(positive(box.l - xi), box);
    const Kink<Real> high(positive(xi + box.l - 1.0), box);
    s = {low.s, 1.0 - xi - 2.0 * low.s + high.s, xi + low.s - 2.0 * high.s, high.s};
    g = {-low.g, 2.0 * low.g + high.g - axis.per_h, axis.per_h - low.g - 2.0 * high.g, high.g};
    second_moment = axis.h * axis.h * (xi * (1.0 - xi) + 2.0 * (low.s + high.s));
  }

  /// S of one box and G of another: no longer the derivative of S, but sums of G and of G x are kept.
  template <typename Length>
  CellWeights(Real xi, const Axis& axis, const HalfSide<Length>& box, const HalfSide<Length>& of_gradient)
      : CellWeights(xi, axis, box) {
    g = CellWeights(xi, axis, of_gradient).g;
  }
};

/// S and G of the three nodes from the first one that the box touches on, for particles at xi in [l, 1 + l]
/// cells above it and l <= h/2. In this form nothing cancels as the box leaves that node: mass and force
/// there shrink together, as low^2 and low, and no node is left with a force that its mass does not go with.
template <typename Real>
struct RowWeights {
  std::array<Real, 3> s, g;
  Real second_moment; ///< as in CellWeights

  template <typename Length>
  RowWeights(Real xi, const Axis& axis, const HalfSide<Length>& box) {
    const Real past = positive(xi + box.l - 1.0);
    const Kink<Real> high(past, box);
    const Kink<Real> low(2.0 * box.l - past, box);
    const Real s_first = low.s + positive(1.0 - box.l - xi);
    s = {s_first, 1.0 - s_first - high.s, high.s};
    g = {-low.g, low.g - high.g, high.g};
    second_moment = axis.h * axis.h * (xi * (1.0 - xi) + 2.0 * high.s);
  }

  /// S of one box and G of another that is no wider: it may touch two of the three nodes alone.
  RowWeights(Real xi, const Axis& axis, const HalfSide<Real>& box, const HalfSide<Real>& of_gradient)
      : RowWeights(xi, axis, box) {
    const Real past = smaller(positive(xi + of_gradient.l - 1.0), 2.0 * of_gradient.l);
    const Kink<Real> high(past, of_gradient);
    const Kink<Real> low(2.0 * of_gradient.l - past, of_gradient);
    g = {-low.g, low.g - high.g, high.g};
  }
};

/// Weights of four consecutive nodes.
struct Weights {
  int base = 0; ///< the first of them
  Lanes s;      ///< S
  Lanes g;      ///< dS/dx, 1/m
};

/// Weights from the first node on that a box touches, of half side (m) at most h/2: the last of the four is
/// zero.
inline Weights gimp_weights(double x, const Axis& axis, double half_side) {
  const HalfSide<double> box(half_side, axis);
  const double position = axis.cells(x);
  const double base = std::floor(position - box.l);
  const RowWeights<double> w(position - base, axis, box);
  return {static_cast<int>(base), Lanes{w.s[0], w.s[1], w.s[2], 0.0}, Lanes{w.g[0], w.g[1], w.g[2], 0.0}};
}

/// Weights from the node before the particle's cell on, of half side (m) at most h: the same four nodes for
/// all particles of a cell.
inline Weights cell_weights(double x, const Axis& axis, double half_side) {
  const double position = axis.cells(x);
  const double cell = std::floor(position);
  const CellWeights<double> w(position - cell, axis, HalfSide<double>(half_side, axis));
  return {static_cast<int>(cell) - 1, Lanes{w.s[0], w.s[1], w.s[2], w.s[3]},
          Lanes{w.g[0], w.g[1], w.g[2], w.g[3]}};
}

} // namespace tremolo::mpm_domain
