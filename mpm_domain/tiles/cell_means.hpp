#pragma once

// Means over the particles of a cell, sum w q / sum w. A cell is the leaf that holds a particle's centre; its
// sums stand at its lower left node, NodeFields::cell_weight and cell_change. Particles on one lattice add
// theirs in the window of their tile, and particles that touch several lattices are added afterwards.

#include "mpm_domain/ground.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

inline constexpr SumRange cell_sums = sums_between(Sum::cell_weight, Sum::cell_change);

/// Finds the cells of the particles of a tile, or of particles that touch several lattices.
class CellFinder {
public:
  CellFinder(const TileMap& tiles, std::size_t tile)
      : lattice_(&tiles.lattice(tiles.level_of(tile))), per_h_(1.0 / lattice_->h),
        position_(tiles.window(tile)) {}
  explicit CellFinder(const GradedMesh& mesh) : mesh_(&mesh) {}

  struct Cell {
    std::size_t node;      ///< its lower left one
    std::size_t in_window; ///< where that stands in the window of the tile, if there is one
  };
  Cell at(double x, double y) const {
    if (mesh_ != nullptr)
      return {leaf_at(x, y), 0};
    const int column = static_cast<int>(std::floor((x - lattice_->x0) * per_h_));
    const int row = static_cast<int>(std::floor((y - lattice_->y0) * per_h_));
    return {lattice_->index(column, row),
            static_cast<std::size_t>((row - position_.row) * window_columns + column - position_.column)};
  }

private:
  /// The lower left node of the leaf that holds a point.
  std::size_t leaf_at(double x, double y) const;

  const GradedMesh* mesh_ = nullptr;
  const Lattice* lattice_ = nullptr;
  double per_h_ = 0.0; ///< 1/h, 1/m
  NodeBlock position_; ///< of the window
};

/// Layout of a tile's sums over cells in its window.
struct CellWindow {
  double *weight, *change;

  explicit CellWindow(double* window)
      : weight(window + cell_sums.first * window_nodes), change(weight + window_nodes) {}
  void add(std::size_t cell, double w, double wq) const {
    weight[cell] += w;
    change[cell] += wq;
  }
};

/// All rows of a tile's window: cells begin one row below the nodes that their particles touch, or with them.
inline RowRange rows_of_window(const Ground& ground, std::size_t tile) {
  const NodeBlock window = ground.tiles.window(tile);
  return {window.row, window.end_row()};
}

/// Sets the sums over cells to zero.
void clear_cells(Ground& ground);

struct CellValues {
  std::size_t cell;
  double weight, change;
};

/// The images of a period take the sums of the cells that they stand for.
void join_images_of_cells(Ground& ground);

/// Adds what particles that touch several lattices bring to their cells, then the images of a period to the
/// cells that they are. They are few, so one thread does it.
/// @param takes_part  (set) whether its particles do
/// @param values_of   (set, particle) -> {cell, w, w q}
template <typename TakesPart, typename ValuesOf>
void complete_cells(Ground& ground, const ClockTiles& tiles, const TakesPart& takes_part,
                    const ValuesOf& values_of) {
  for (const AcrossTile& tile : tiles.across) {
    if (!takes_part(ground.sets[tile.set]))
      continue;
    for (std::size_t k = tile.weights.first(); k < tile.weights.end(); ++k) {
      const CellValues values = values_of(tile.set, k);
      ground.grid.cell_weight[values.cell] += values.weight;
      ground.grid.cell_change[values.cell] += values.change;
    }
  }
  join_images_of_cells(ground);
}

/// The mean of a cell.
inline double mean_of_cell(const Grid& grid, std::size_t cell) {
  return grid.cell_change[cell] / grid.cell_weight[cell];
}

} // namespace tremolo::mpm_domain
