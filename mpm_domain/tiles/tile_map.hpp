#pragma once

// The lattices are cut into tiles of 32 x 8 cells. The first tile of a lattice begins at its first node, and
// tiles are numbered lattice after lattice and row after row. The cut depends on nothing but the grid, so the
// tiles are the same for any number of threads.

#include "mesh/quadtree.hpp"
#include "mpm_domain/spec/lattice.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace tremolo::mpm_domain {

inline constexpr int tile_columns = 32;
inline constexpr int tile_rows = 8;
inline constexpr std::size_t cells_per_tile = std::size_t{tile_columns} * tile_rows;

/// A block of `columns` by `rows` nodes whose first node is (column, row). It may reach beyond the lattice.
struct NodeBlock {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;

  int end_column() const { return column + columns; }
  int end_row() const { return row + rows; }
  bool empty() const { return columns <= 0 || rows <= 0; }
};

/// The nodes that two blocks have in common; empty() if there are none.
NodeBlock overlap(const NodeBlock& a, const NodeBlock& b);

/// Rows [begin, end) of a lattice.
struct RowRange {
  int begin = std::numeric_limits<int>::max();
  int end = std::numeric_limits<int>::min();

  void add(const RowRange& more) {
    begin = std::min(begin, more.begin);
    end = std::max(end, more.end);
  }
};

class TileMap {
public:
  TileMap() = default;
  explicit TileMap(std::vector<Lattice> lattices);

  /// Number of tiles of all lattices together.
  std::size_t count() const { return starts_.back(); }
  /// The tiles of a lattice are [first(level), first(level + 1)).
  std::size_t first(int level) const { return starts_[static_cast<std::size_t>(level)]; }
  int lattice_count() const { return static_cast<int>(lattices_.size()); }
  /// The largest number of tiles in a row of any lattice.
  std::size_t most_columns() const;
  const Lattice& lattice(int level) const { return lattices_[static_cast<std::size_t>(level)]; }

  int level_of(std::size_t tile) const;
  /// The nodes that a tile owns. Every node of a lattice belongs to exactly one tile.
  NodeBlock owned(std::size_t tile) const;
  /// The tile that owns a node. For a node beyond the lattice it is the nearest tile.
  std::size_t tile_of(int level, int column, int row) const;
  /// The nodes that the particles of a tile may touch. A particle belongs to the tile that owned the first
  /// node of its stencil at the last sort. Since then it may have moved by up to one cell in any direction,
  /// and its stencil reaches three nodes beyond the first: one node is added before the tile and four behind
  /// it.
  NodeBlock window(std::size_t tile) const;
  /// Whether a box holds nodes that the particles of a tile may touch, or lies between them.
  bool reaches(std::size_t tile, const mesh::Rectangle& box) const;
  /// The tiles of a lattice of which that holds, rising.
  std::vector<std::size_t> reaching(int level, const mesh::Rectangle& box) const;
  /// The tiles of the same lattice whose windows may hold nodes that this tile owns, itself included, in
  /// rising order.
  std::vector<std::size_t> around(std::size_t tile) const;

private:
  /// A tile's level, and its column and row among the tiles of that lattice.
  struct Place {
    int level;
    int column;
    int row;
  };
  Place position_of(std::size_t tile) const;
  int columns(int level) const { return (lattice(level).nx + tile_columns - 1) / tile_columns; }
  int rows(int level) const { return (lattice(level).ny + tile_rows - 1) / tile_rows; }

  std::vector<Lattice> lattices_;
  std::vector<std::size_t> starts_{0};
};

/// Every window has the same size, also at the edge of a lattice.
inline constexpr int window_columns = tile_columns + 5;
inline constexpr int window_rows = tile_rows + 5;
inline constexpr std::size_t window_nodes = std::size_t{window_columns} * window_rows;

} // namespace tremolo::mpm_domain
