#pragma once

// The weights of a chunk of particles on one lattice, for passes that add up particles. They add in the
// window of a tile, and never beyond it: a particle whose stencil leaves the window, because it went farther
// from one sort to the next than a cell, or is nowhere, ends the run before its chunk is added.

#include "mpm_domain/tiles/tile_sums.hpp"
#include "mpm_domain/transfer/out_of_reach.hpp"
#include "mpm_domain/transfer/stencil.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace tremolo::mpm_domain {

/// Particles whose weights are held at a time, in the first-level cache.
inline constexpr std::size_t chunk = 64;

/// Weights of a chunk of particles: along x those of four nodes, along y one number per row.
template <std::size_t rows>
struct ChunkWeights {
  std::array<std::int32_t, chunk> first; ///< first node of the stencil, in the window
  std::array<std::int32_t, chunk> cell;  ///< lower left node of the cell, in the window
  std::array<Lanes, chunk> xs, xg;
  std::array<std::array<double, chunk>, rows> ys, yg;
  std::array<double, chunk> xi, eta;      ///< cells above node 1 of a row, above row 0
  std::array<double, chunk> per_x, per_y; ///< diagonal of D^-1, 1/m2
};

/// The first nodes of the stencils of the particles seen so far, for each of the four lanes: the least and
/// the last column of the lattice, and the least and the last index in the window. As indices have no sign,
/// what lies before the window comes behind it, and so does what is not a number.
class FirstNodes {
public:
  /// @param rows  of one stencil
  FirstNodes(const NodeBlock& window, std::size_t rows) : window_(window), rows_(static_cast<int>(rows)) {}

  template <typename Group>
  [[gnu::always_inline]] void see(const Lanes& columns, const std::array<std::int32_t, 4>& first,
                                  Group group) {
    least_column_ = group.present(smaller(columns, least_column_), least_column_);
    last_column_ = group.present(larger(columns, last_column_), last_column_);
    std::array<std::int32_t, 4> present = first;
    if constexpr (!std::is_same_v<Group, Four>)
      std::fill(present.begin() + group.count, present.end(), first[0]);
    const __m128i index = _mm_loadu_si128(reinterpret_cast<const __m128i*>(present.data()));
    least_ = _mm_min_epu32(least_, index);
    last_ = _mm_max_epu32(last_, index);
  }

  /// Whether all of the stencils lie in the window.
  bool in_window() const {
    const __m128i allowed = _mm_set1_epi32((window_.rows - rows_ + 1) * window_.columns - stencil_columns);
    const __m128i in_rows = _mm_cmpeq_epi32(_mm_max_epu32(last_, allowed), allowed);
    return _mm_movemask_epi8(in_rows) == 0xffff &&
           !any((least_column_ < static_cast<double>(window_.column)) |
                (last_column_ > static_cast<double>(window_.end_column() - stencil_columns)));
  }

  /// The rows of the lattice that the stencils cover.
  RowRange rows() const {
    const auto row_of = [this](std::uint32_t index) {
      return window_.row + static_cast<int>(index) / window_.columns;
    };
    return {row_of(std::ranges::min(lanes(least_))), row_of(std::ranges::max(lanes(last_))) + rows_};
  }

private:
  static constexpr int stencil_columns = 4;
  static constexpr double far = std::numeric_limits<double>::infinity();

  static std::array<std::uint32_t, 4> lanes(const __m128i& indices) {
    std::array<std::uint32_t, 4> values;
    _mm_storeu_si128(reinterpret_cast<__m128i*>(values.data()), indices);
    return values;
  }

  NodeBlock window_;
  int rows_;
  Lanes least_column_ = all(far);
  Lanes last_column_ = all(-far);
  __m128i least_ = _mm_set1_epi32(-1);
  __m128i last_ = _mm_setzero_si128();
};

/// Ends the run over the first of some particles whose stencil is not in a window.
template <typename Boxes>
[[noreturn, gnu::noinline, gnu::cold]] void
refuse_stray(const Particles& p, std::size_t begin, std::size_t end, const NodeBlock& window,
             const Axis& x_axis, const Axis& y_axis, const Boxes& boxes) {
  const FewerThanFour one(1);
  const auto is_stray = [&](std::size_t k) {
    const Stencils at(one.load(&p.x[k]), one.load(&p.y[k]), x_axis, y_axis, boxes.of(k, one));
    FirstNodes first(window, Boxes::rows);
    first.see(at.x0, at.first_nodes(NodeArray(window)), one);
    return !first.in_window();
  };
  std::size_t k = begin;
  while (k + 1 < end && !is_stray(k))
    ++k;
  refuse_stray(p, k, x_axis.h);
}

/// @tparam cells  whether the cells of the particles are asked for
template <bool force, bool affine, bool cells = false, typename Boxes, typename Group>
[[gnu::always_inline]] inline void take_weights(const Particles& p, std::size_t k, std::size_t c, Group group,
                                                const NodeArray& nodes, const Axis& x_axis,
                                                const Axis& y_axis, const Boxes& boxes,
                                                ChunkWeights<Boxes::rows>& w, FirstNodes& seen) {
  const auto& own = boxes.of(k, group);
  const Stencils at(group.load(&p.x[k]), group.load(&p.y[k]), x_axis, y_axis, own);
  const std::array<std::int32_t, 4> first = at.first_nodes(nodes);
  seen.see(at.x0, first, group);
  std::copy(first.begin(), first.end(), &w.first[c]);
  const auto wx = own.along_x(at.xi, x_axis);
  const auto wy = own.along_y(at.eta, y_axis);
  const std::array<Lanes, 4> s = transposed(wx.s);
  for (std::size_t i = 0; i < 4; ++i)
    w.xs[c + i] = s[i];
  for (std::size_t j = 0; j < Boxes::rows; ++j)
    store(&w.ys[j][c], wy.s[j]);
  if constexpr (force) {
    const std::array<Lanes, 4> g = transposed(wx.g);
    for (std::size_t i = 0; i < 4; ++i)
      w.xg[c + i] = g[i];
    for (std::size_t j = 0; j < Boxes::rows; ++j)
      store(&w.yg[j][c], wy.g[j]);
  }
  if constexpr (cells) {
    const std::array<std::int32_t, 4> cell = at.cells(nodes);
    std::copy(cell.begin(), cell.end(), &w.cell[c]);
  }
  if constexpr (affine) {
    store(&w.xi[c], at.xi);
    store(&w.eta[c], at.eta);
    const Lanes per_both = 1.0 / (wx.second_moment * wy.second_moment); // a division costs more than all else
    store(&w.per_x[c], wy.second_moment * per_both);
    store(&w.per_y[c], wx.second_moment * per_both);
  }
}

} // namespace tremolo::mpm_domain
