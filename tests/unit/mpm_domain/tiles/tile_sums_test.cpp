// Sums of tiles: nodes get what all windows hold, in the order of tiles whatever order they are filled in.

#include "mpm_domain/tiles/tile_sums.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tremolo::mpm_domain {
namespace {

constexpr SumRange all_fields{0, particle_sums.size()};
const Lattice lattice{1.0, 0.0, 0.0, 100, 40, 0};

/// What a tile brings to a node in a field: numbers whose sum depends on the order of its terms.
double term(std::size_t tile, std::size_t field, int column, int row) {
  return 1.0 / (1.0 + static_cast<double>(tile) + 0.1 * static_cast<double>(field) + column + 0.7 * row);
}

NodeFields zero_fields() {
  NodeFields nodes;
  for (NodeField NodeFields::*field : particle_sums)
    (nodes.*field).assign(lattice.count(), 0.0);
  return nodes;
}

struct Sums {
  TileMap tiles{{lattice}};
  std::vector<std::size_t> filled{0, 1, 2, 5, 6, 9, 10, 15};

  /// The nodes of the lattice in a tile's window: particles touch no others.
  NodeBlock touched(std::size_t tile) const {
    return overlap(tiles.window(tile), {0, 0, lattice.nx, lattice.ny});
  }

  RowRange fill(std::size_t tile, double* window) const {
    const NodeBlock at = tiles.window(tile);
    const NodeBlock part = touched(tile);
    for (std::size_t f = 0; f < particle_sums.size(); ++f)
      for (int j = part.row; j < part.end_row(); ++j)
        for (int i = part.column; i < part.end_column(); ++i)
          window[f * window_nodes + static_cast<std::size_t>((j - at.row) * window_columns + i -
                                                             at.column)] += term(tile, f, i, j);
    return {part.row, part.end_row()};
  }

  /// The sums that adding tile after tile gives.
  NodeFields expected(int times) const {
    NodeFields nodes = zero_fields();
    for (int time = 0; time < times; ++time)
      for (const std::size_t tile : filled) {
        const NodeBlock part = touched(tile);
        for (std::size_t f = 0; f < particle_sums.size(); ++f)
          for (int j = part.row; j < part.end_row(); ++j)
            for (int i = part.column; i < part.end_column(); ++i)
              (nodes.*particle_sums[f])[lattice.index(i, j)] += term(tile, f, i, j);
      }
    return nodes;
  }
};

TEST(TileSums, AreAddedInTheOrderOfTilesByAnyNumberOfThreads) {
  const Sums sums;
  const NodeFields expected = sums.expected(3);
  for (const int threads : {1, 2, 3, 8}) {
    WorkerPool workers(threads);
    WindowPool windows;
    TileSums tile_sums(sums.tiles, sums.filled);
    NodeFields nodes = zero_fields();
    for (int time = 0; time < 3; ++time) // windows of the first are filled again
      tile_sums.add_to(nodes, all_fields, sums.tiles, workers, windows,
                       [&](std::size_t n, double* window) { return sums.fill(sums.filled[n], window); });
    for (NodeField NodeFields::*field : particle_sums)
      EXPECT_EQ(nodes.*field, expected.*field) << threads;
  }
}

/// A pass that no particle of a tile takes part in.
TEST(TileSums, OfATileThatAddsNothingAreNone) {
  const Sums sums;
  WorkerPool workers(1);
  WindowPool windows;
  TileSums tile_sums(sums.tiles, sums.filled);
  NodeFields nodes = zero_fields();
  tile_sums.add_to(nodes, all_fields, sums.tiles, workers, windows, [](auto, auto) { return RowRange{}; });
  for (NodeField NodeFields::*field : particle_sums)
    EXPECT_EQ(nodes.*field, zero_fields().*field);
}

TEST(TileSums, LeaveFieldsThatAreNotAskedForAlone) {
  const Sums sums;
  WorkerPool workers(1);
  WindowPool windows;
  TileSums tile_sums(sums.tiles, sums.filled);
  NodeFields nodes = zero_fields();
  tile_sums.add_to(nodes, {1, 3}, sums.tiles, workers, windows, [&](std::size_t n, double* window) {
    std::fill_n(window + window_nodes, 2 * window_nodes, 1.0);
    const NodeBlock at = sums.touched(sums.filled[n]);
    return RowRange{at.row, at.end_row()};
  });
  EXPECT_EQ(nodes.mass, zero_fields().mass);
  EXPECT_EQ(nodes.force_x, zero_fields().force_x);
  EXPECT_NE(nodes.momentum_y, zero_fields().momentum_y);
}

} // namespace
} // namespace tremolo::mpm_domain
