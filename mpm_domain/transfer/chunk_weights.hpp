#pragma once

// The weights of a chunk of particles on one lattice, for passes that add up particles.

#include "mpm_domain/tiles/tile_sums.hpp"
#include "mpm_domain/transfer/stencil.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace tremolo::mpm_domain {

/// Particles whose weights are held at a time, in the first-level cache.
inline constexpr std::size_t chunk = 64;

/// Weights of a chunk of particles: along x those of four nodes, along y one number per row.
template <std::size_t rows>
struct ChunkWeights {
  std::array<std::int32_t, chunk> first; ///< first node of the stencil, in the window
  std::array<Lanes, chunk> xs, xg;
  std::array<std::array<double, chunk>, rows> ys, yg;
  std::array<double, chunk> xi, eta;      ///< cells above node 1 of a row, above row 0
  std::array<double, chunk> per_x, per_y; ///< diagonal of D^-1, 1/m2
};

/// The least and the largest first row among the particles seen so far, for each of the four lanes.
struct FirstRows {
  static constexpr double far = std::numeric_limits<double>::infinity();
  Lanes least = all(far);
  Lanes last = all(-far);

  template <typename Group>
  [[gnu::always_inline]] void see(const Lanes& rows, Group group) {
    least = group.present(smaller(rows, least), least);
    last = group.present(larger(rows, last), last);
  }

  /// The rows that the stencils of these particles cover.
  /// @param rows  of one stencil
  RowRange stencils(std::size_t rows) const {
    return {static_cast<int>(std::min(std::min(least[0], least[1]), std::min(least[2], least[3]))),
            static_cast<int>(std::max(std::max(last[0], last[1]), std::max(last[2], last[3]))) +
                static_cast<int>(rows)};
  }
};

template <bool force, bool affine, typename Boxes, typename Group>
[[gnu::always_inline]] inline void take_weights(const Particles& p, std::size_t k, std::size_t c, Group group,
                                                const NodeArray& nodes, const Axis& x_axis,
                                                const Axis& y_axis, const Boxes& boxes,
                                                ChunkWeights<Boxes::rows>& w, FirstRows& seen) {
  const auto& own = boxes.of(k, group);
  const Stencils at(group.load(&p.x[k]), group.load(&p.y[k]), x_axis, y_axis, own);
  seen.see(at.y0, group);
  const std::array<std::int32_t, 4> first = at.first_nodes(nodes);
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
  if constexpr (affine) {
    store(&w.xi[c], at.xi);
    store(&w.eta[c], at.eta);
    const Lanes per_both = 1.0 / (wx.second_moment * wy.second_moment); // a division costs more than all else
    store(&w.per_x[c], wy.second_moment * per_both);
    store(&w.per_y[c], wx.second_moment * per_both);
  }
}

} // namespace tremolo::mpm_domain
