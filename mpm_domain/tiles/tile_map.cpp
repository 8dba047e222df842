#include "mpm_domain/tiles/tile_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Number of cells that a particle may have moved to the left or down since the last sort.
constexpr int halo = 1;

} // namespace

NodeBlock overlap(const NodeBlock& a, const NodeBlock& b) {
  NodeBlock both{std::max(a.column, b.column), std::max(a.row, b.row)};
  both.columns = std::min(a.end_column(), b.end_column()) - both.column;
  both.rows = std::min(a.end_row(), b.end_row()) - both.row;
  return both;
}

TileMap::TileMap(std::vector<Lattice> lattices) : lattices_(std::move(lattices)) {
  for (int level = 0; level < static_cast<int>(lattices_.size()); ++level)
    starts_.push_back(starts_.back() + static_cast<std::size_t>(columns(level) * rows(level)));
}

std::size_t TileMap::most_columns() const {
  int most = 0;
  for (int level = 0; level < static_cast<int>(lattices_.size()); ++level)
    most = std::max(most, columns(level));
  return static_cast<std::size_t>(most);
}

int TileMap::level_of(std::size_t tile) const {
  return static_cast<int>(std::ranges::upper_bound(starts_, tile) - starts_.begin()) - 1;
}

TileMap::Place TileMap::position_of(std::size_t tile) const {
  const int level = level_of(tile);
  const int n = static_cast<int>(tile - first(level));
  return {level, n % columns(level), n / columns(level)};
}

NodeBlock TileMap::owned(std::size_t tile) const {
  const auto [level, column, row] = position_of(tile);
  return overlap({column * tile_columns, row * tile_rows, tile_columns, tile_rows},
                 {0, 0, lattice(level).nx, lattice(level).ny});
}

std::size_t TileMap::tile_of(int level, int column, int row) const {
  const int i = std::clamp(column / tile_columns, 0, columns(level) - 1);
  const int j = std::clamp(row / tile_rows, 0, rows(level) - 1);
  return first(level) + static_cast<std::size_t>(j * columns(level) + i);
}

NodeBlock TileMap::window(std::size_t tile) const {
  const NodeBlock own = owned(tile);
  return {own.column - halo, own.row - halo, window_columns, window_rows};
}

bool TileMap::reaches(std::size_t tile, const mesh::Rectangle& box) const {
  const Lattice& of = lattice(level_of(tile));
  const NodeBlock nodes = window(tile);
  return of.x0 + nodes.column * of.h < box.x_max && of.x0 + nodes.end_column() * of.h > box.x_min &&
         of.y0 + nodes.row * of.h < box.y_max && of.y0 + nodes.end_row() * of.h > box.y_min;
}

std::vector<std::size_t> TileMap::reaching(int level, const mesh::Rectangle& box) const {
  const Lattice& of = lattice(level);
  const auto node = [&](double x, double x0) { return static_cast<int>(std::floor((x - x0) / of.h)); };
  const auto [level_low, first_column, first_row] = position_of(
      tile_of(level, node(box.x_min, of.x0) - window_columns, node(box.y_min, of.y0) - window_rows));
  const auto [level_high, last_column, last_row] = position_of(
      tile_of(level, node(box.x_max, of.x0) + window_columns, node(box.y_max, of.y0) + window_rows));
  std::vector<std::size_t> tiles;
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column)
      if (const std::size_t tile = first(level) + static_cast<std::size_t>(row * columns(level) + column);
          reaches(tile, box))
        tiles.push_back(tile);
  return tiles;
}

std::vector<std::size_t> TileMap::around(std::size_t tile) const {
  const auto [level, column, row] = position_of(tile);
  std::vector<std::size_t> tiles;
  for (int j = std::max(0, row - 1); j <= std::min(rows(level) - 1, row + 1); ++j)
    for (int i = std::max(0, column - 1); i <= std::min(columns(level) - 1, column + 1); ++i)
      tiles.push_back(first(level) + static_cast<std::size_t>(j * columns(level) + i));
  return tiles;
}

} // namespace tremolo::mpm_domain
