#pragma once

// Boxes of two kinds in one gradient. With the hat functions N averaged over boxes of half sides l,
//
//     G_x = N'(x; l_L) S(y; l_T),      G_y = S(x; l_T) N'(y; l_L),      l_L = 0.44 h,  l_T = 0.5 h,
//
// is taken for strains and internal forces in place of the derivative of S(x; l) S(y; l), l = h/4, which
// masses and velocities keep. The sums of G over the nodes (0) and of x G (1) are those of any gradient, so
// uniform strains are exact, and forces have neither sum nor torque. These half sides make the three numbers
// by which a grid errs in (k h)^2, along, across and between both, nearly equal: 0.2526, 0.2500, 0.2519. With
// boxes of h/4 they are 0.083, 0.188 and 0.167, which no filter of nodes can bring to zero together.
//
// At a free surface a box shrinks on the side where soil ends: let xi be the particle's place in its cell,
// e_0 and e_3 the least fullness (dispersion/fullness.hpp) of the nodes before and behind the cell in those
// rows that the wide box touches. Then for L = l_L and l_T,
//
//     a = max(l, min(xi, L)),    b = max(l, min(1 - xi, L)),    L <- min(a + e_0 (L - a), b + e_3 (L - b)),
//
// and likewise along y. No node gets a force that its mass does not go with.

#include "mpm_domain/fields/node_fields.hpp"
#include "mpm_domain/kernel/kernel.hpp"
#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/transfer/stencil.hpp"

#include <array>
#include <cstdint>

namespace tremolo::mpm_domain {

/// The boxes of four particles.
struct WideBoxes {
  HalfSide<Lanes> x_value, x_slope, y_value, y_slope; ///< l_T and l_L of both directions

  Lanes first_row(const Lanes& row) const { return floor(row - y_value.l); }
  CellWeights<Lanes> along_x(const Lanes& xi, const Axis& axis) const { return {xi, axis, x_value, x_slope}; }
  RowWeights<Lanes> along_y(const Lanes& eta, const Axis& axis) const {
    return {eta, axis, y_value, y_slope};
  }
};

/// The boxes of a set on a grid of one lattice whose fullness is known.
class WideSquares {
public:
  static constexpr std::size_t rows = 3;
  static constexpr bool follow = false;

  WideSquares(const Particles& p, const Lattice& lattice, const NodeFields& nodes);

  /// The boxes of a group of particles from k on, until the next call.
  template <typename Group>
  [[gnu::always_inline]] const WideBoxes& of(std::size_t k, Group group) const {
    const Lanes x = x_axis_.cells(group.load(x_ + k));
    const Lanes y = y_axis_.cells(group.load(y_ + k));
    const Lanes column = floor(x);
    const Lanes row = floor(y);
    const __m128i index = _mm256_cvttpd_epi32(row * array_.row + (column + first_));
    std::array<std::int32_t, 4> first;
    _mm_storeu_si128(reinterpret_cast<__m128i*>(first.data()), index);
    double inside = 1.0;
    for (std::size_t lane = 0; lane < group.count; ++lane)
      inside *= inside_block_[first[lane]];
    return inside == 1.0 ? full_ : shrunk(x - column, y - row, first, group.count);
  }

private:
  [[gnu::noinline]] const WideBoxes& shrunk(const Lanes& xi, const Lanes& eta,
                                            const std::array<std::int32_t, 4>& first,
                                            std::size_t count) const;

  const double *x_, *y_;
  const double *fullness_, *inside_block_;
  Axis x_axis_, y_axis_;
  NodeArray array_;
  double first_;          ///< the first node of a particle's stencil for one in cell (0, 0)
  std::ptrdiff_t row_;    ///< nodes from one row to the next
  double own_;            ///< l, in cells
  double along_, across_; ///< l_L and l_T, in cells
  WideBoxes full_;
  mutable WideBoxes shrunk_;
};

} // namespace tremolo::mpm_domain
