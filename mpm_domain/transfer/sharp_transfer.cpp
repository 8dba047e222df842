#include "mpm_domain/transfer/sharp_transfer.hpp"

#include "mpm_domain/dispersion/sharpening.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"
#include "mpm_domain/transfer/wide_squares.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// The internal forces of a range of particles.
/// @returns the rows of the lattice that they touch
[[gnu::flatten]] RowRange scatter_wide(const Particles& p, const ParticleRange& range, const Lattice& lattice,
                                       const NodeBlock& position, double* window, const NodeFields& fields) {
  const NodeArray nodes(position);
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  const WideSquares boxes(p, lattice, fields);
  ChunkWeights<WideSquares::rows> w;
  FirstNodes seen(position, WideSquares::rows);
  ChunkStore store;
  for (std::size_t k = range.begin; k < range.end; k += chunk) {
    const std::size_t count = std::min(chunk, range.end - k);
    by_fours(0, count, [&](std::size_t c, auto group) {
      take_weights<true, false>(p, k + c, c, group, nodes, x_axis, y_axis, boxes, w, seen);
    });
    if (!seen.in_window())
      refuse_stray(p, k, k + count, position, x_axis, y_axis, boxes);
    const Arrays soil = SoilPhase::arrays<true>(p, k, count, window, store);
    constexpr Lanes no_weight{};
    scatter_phase<SoilPhase::pull, Motion::none, true, Around::uniform>(soil, count, w, lattice.h, no_weight);
  }
  return seen.rows();
}

} // namespace

void scatter_sharp_forces(Ground& ground) {
  clear(ground, NodeGroup::force, ground.soil_rows);
  constexpr SumRange fields = fields_of<SoilPhase>(Motion::none, true);
  add_sums(
      ground, 0, std::array{fields},
      [&](const Particles& p, std::size_t tile, double* window) {
        const ParticleRange range = p.in_block(ground.block(0, tile));
        if (range.begin == range.end)
          return RowRange{};
        return scatter_wide(p, range, ground.tiles.lattice(ground.tiles.level_of(tile)),
                            ground.tiles.window(tile), window, ground.grid);
      },
      [](AcrossTile&) {});
  fold(ground, NodeGroup::force);
  sharpen_forces(ground);
}

void sharpen_strain(Ground& ground) {
  prolong(ground, NodeGroup::velocity);
  take_at_skirt(ground, std::array{&NodeFields::vx_strain, &NodeFields::vy_strain});
  Grid& grid = ground.grid;
  sharpen_velocities(ground, grid.vx_strain, grid.vy_strain);
  std::swap(grid.vx_strain, grid.sharp_x);
  std::swap(grid.vy_strain, grid.sharp_y);
  prolong(ground, NodeGroup::velocity, ground.soil_ties);
}

Vector sharp_reading(const Ground& ground, const Particles& particles, std::size_t k,
                     const NodeField& field_x, const NodeField& field_y) {
  const Grid& grid = ground.grid;
  const Weights wx = cell_weights(particles.x[k], ground.x_axis(), particles.half_size);
  const Weights wy = cell_weights(particles.y[k], ground.y_axis(), particles.half_size);
  const auto half_moment = [](const Weights& w, double position) {
    double moment = 0.0;
    for (int i = 0; i < 4; ++i)
      moment += w.s[i] * std::pow(w.base + i - position, 2);
    return 0.5 * moment;
  };
  const double along = half_moment(wx, ground.x_axis().cells(particles.x[k]));
  const double up = half_moment(wy, ground.y_axis().cells(particles.y[k]));
  const auto row = static_cast<std::size_t>(grid.nx);
  const auto corrected = [&](const NodeField& v, std::size_t n) {
    return v[n] + along * grid.inside_x[n] * (2.0 * v[n] - v[n - 1] - v[n + 1]) +
           up * grid.inside_y[n] * (2.0 * v[n] - v[n - row] - v[n + row]);
  };
  Vector sum;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const std::size_t n = grid.index(wx.base + i, wy.base + j);
      const double s = wx.s[i] * wy.s[j];
      if (s == 0.0)
        continue;
      sum.x += s * corrected(field_x, n);
      sum.y += s * corrected(field_y, n);
    }
  return sum;
}

} // namespace tremolo::mpm_domain
