#pragma once

// The lattices cut into tiles of 32 x 8 cells from their first node on, lattice after lattice and row after
// row. The cut depends on nothing but the grid, so whoever works through tiles finds the same ones however
// many threads share them.

#include "mpm_domain/spec/lattice.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::mpm_domain {

inline constexpr int tile_columns = 32;
inline constexpr int tile_rows = 8;
inline constexpr std::size_t cells_per_tile = static_cast<std::size_t>(tile_columns * tile_rows);

/// Nodes of a lattice: `columns` by `rows` of them from (column, row) on. May reach beyond it.
struct NodeBlock {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;

  int end_column() const { return column + columns; }
  int end_row() const { return row + rows; }
  bool empty() const { return columns <= 0 || rows <= 0; }
};

/// What both hold.
NodeBlock overlap(const NodeBlock& a, const NodeBlock& b);

class TileMap {
public:
  TileMap() = default;
  explicit TileMap(std::vector<Lattice> lattices);

  /// Of all lattices together.
  std::size_t count() const { return starts_.back(); }
  /// The tiles of a lattice are [first(level), first(level + 1)).
  std::size_t first(int level) const { return starts_[static_cast<std::size_t>(level)]; }
  /// Of the tiles in a row, on the widest lattice.
  std::size_t most_columns() const;
  const Lattice& lattice(int level) const { return lattices_[static_cast<std::size_t>(level)]; }

  int level_of(std::size_t tile) const;
  /// The nodes that a tile owns: every node of a lattice is owned once.
  NodeBlock owned(std::size_t tile) const;
  /// The tile that owns a node, or the nearest one to a node beyond the lattice.
  std::size_t tile_of(int level, int column, int row) const;
  /// The nodes that particles may touch whose first node a tile owned at the last sort. They may have gone by
  /// a cell since, and boxes reach three nodes on from the first.
  NodeBlock window(std::size_t tile) const;
  /// The tiles of the lattice whose windows may hold nodes that a tile owns, this one among them, in rising
  /// order.
  std::vector<std::size_t> around(std::size_t tile) const;

private:
  /// Place of a tile among those of its lattice.
  struct Place {
    int level;
    int column;
    int row;
  };
  Place place_of(std::size_t tile) const;
  int columns(int level) const { return (lattice(level).nx + tile_columns - 1) / tile_columns; }
  int rows(int level) const { return (lattice(level).ny + tile_rows - 1) / tile_rows; }

  std::vector<Lattice> lattices_;
  std::vector<std::size_t> starts_{0};
};

/// The size of every window.
inline constexpr int window_columns = tile_columns + 5;
inline constexpr int window_rows = tile_rows + 5;
inline constexpr std::size_t window_nodes = static_cast<std::size_t>(window_columns * window_rows);

} // namespace tremolo::mpm_domain
