#pragma once

// uGIMP weights in one direction (Bardenhagen and Kober 2004): the hat function N of the grid averaged over
// the particle's box [x - l, x + l] with l <= h/2,
//
//     S_i = 1/(2l) int N_i dx,      G_i = dS_i/dx.
//
// With u the distance of a point from node i in cells, held within [-1, 1], the hat and its integral are
//
//     N = 1 - |u|,      F = int N du = u - u |u|/2 + const,
//
// and with a and b the two ends of the box S_i = h (F(b) - F(a))/(2l), G_i = (N(b) - N(a))/(2l): no branches,
// four nodes at once. The box touches at most three nodes in a row, so that one of the four or more is zero.

#include "mpm_domain/lanes.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

/// Weights of four consecutive nodes.
struct Weights {
  int base = 0; ///< the first of them
  Lanes s;      ///< S
  Lanes g;      ///< dS/dx, 1/m
};

/// A direction of the grid as the kernel sees it.
struct Axis {
  /// @param origin_  coordinate of node 0, m
  /// @param h_, half_size_  cell size and l, m
  Axis(double origin_, double h_, double half_size_)
      : origin(origin_), h(h_), half_size(half_size_), per_h(1.0 / h_), l(half_size_ / h_),
        per_box(0.5 * h_ / half_size_), per_box_metre(0.5 / half_size_) {}

  /// Place of a coordinate in cells from node 0
  double cells(double x) const { return (x - origin) * per_h; }

  double origin;
  double h;
  double half_size;
  double per_h;         ///< 1/h, 1/m
  double l;             ///< half_size/h
  double per_box;       ///< h/(2 half_size)
  double per_box_metre; ///< 1/(2 half_size), 1/m
};

/// Weights of nodes base .. base + 3 for a particle at `place` (Axis::cells).
inline Weights weights_of(int base, double place, const Axis& axis) {
  constexpr Lanes node = {0.0, 1.0, 2.0, 3.0};
  const double from_base = place - base;
  const Lanes a = clamped(all(from_base - axis.l) - node);
  const Lanes b = clamped(all(from_base + axis.l) - node);
  const Lanes hat_a = 1.0 - magnitude(a);
  const Lanes hat_b = 1.0 - magnitude(b);
  // u - u|u|/2 = u (1 + N)/2
  return {base, 0.5 * axis.per_box * (b * (1.0 + hat_b) - a * (1.0 + hat_a)),
          axis.per_box_metre * (hat_b - hat_a)};
}

/// Weights from the first node that the particle's box touches on: the last of the four is zero.
inline Weights gimp_weights(double x, const Axis& axis) {
  const double place = axis.cells(x);
  return weights_of(static_cast<int>(std::floor(place - axis.l)), place, axis);
}

/// Weights from the node before the particle's cell on: the same four nodes for all particles of a cell.
inline Weights cell_weights(double x, const Axis& axis) {
  const double place = axis.cells(x);
  return weights_of(static_cast<int>(std::floor(place)) - 1, place, axis);
}

/// Nodes minus particle, m.
inline Lanes offsets(const Weights& w, double x, const Axis& axis) {
  constexpr Lanes node = {0.0, 1.0, 2.0, 3.0};
  return all(axis.origin + w.base * axis.h - x) + axis.h * node;
}

/// Second moment sum_i S_i (x_i - x)^2, m2: APIC's inertia of the kernel. Never below l^2/3.
inline double second_moment(const Weights& w, const Lanes& offset) {
  return sum(w.s * offset * offset);
}

} // namespace tremolo::mpm_domain
