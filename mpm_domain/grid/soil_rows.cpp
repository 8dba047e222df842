#include "mpm_domain/grid/soil_rows.hpp"

#include "mpm_domain/ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace tremolo::mpm_domain {

namespace {

/// Marks nodes, row by row and tile by tile.
class Rows {
public:
  explicit Rows(const Ground& ground) : ground_(ground) {
    for (int level = 0; level < ground.lattice_count(); ++level) {
      first_.push_back(parts_.size());
      const Lattice& lattice = ground.lattice(level);
      parts_.resize(parts_.size() +
                    static_cast<std::size_t>(parts_per_row(lattice)) * static_cast<std::size_t>(lattice.ny));
    }
  }

  /// Nodes that a box touches on a lattice.
  /// @param whole  take whole rows
  void touch(int level, const mesh::Rectangle& box, bool whole) {
    const Lattice& lattice = ground_.lattice(level);
    const auto cell = [&](double x, double x0) { return static_cast<int>(std::floor((x - x0) / lattice.h)); };
    const int first = whole ? 0 : cell(box.x_min, lattice.x0);
    const int last = whole ? lattice.nx - 1 : cell(box.x_max, lattice.x0) + 1;
    const int low = cell(box.y_min, lattice.y0);
    touch(level, {first, low, last - first + 1, cell(box.y_max, lattice.y0) + 2 - low});
  }

  void touch(int level, const NodeBlock& nodes) {
    const Lattice& lattice = ground_.lattice(level);
    const NodeBlock inside = overlap(nodes, {0, 0, lattice.nx, lattice.ny});
    for (int j = inside.row; j < inside.end_row(); ++j)
      for (int i = inside.column; i < inside.end_column(); i = (i / tile_columns + 1) * tile_columns)
        part(level, j, i).extend(i, std::min(inside.end_column(), (i / tile_columns + 1) * tile_columns) - 1);
  }

  void touch(std::size_t node) {
    const auto [level, row, column] = position_of(node);
    part(level, row, column).extend(column, column);
  }

  bool holds(std::size_t node) {
    const auto [level, row, column] = position_of(node);
    const Part& r = part(level, row, column);
    return r.first <= column && column <= r.last;
  }

  std::vector<NodeRange> ranges() const {
    std::vector<NodeRange> ranges;
    std::size_t p = 0;
    for (int level = 0; level < ground_.lattice_count(); ++level) {
      const Lattice& lattice = ground_.lattice(level);
      for (int j = 0; j < lattice.ny; ++j)
        for (int n = 0; n < parts_per_row(lattice); ++n, ++p)
          if (const Part& r = parts_[p]; r.first <= r.last)
            ranges.push_back({lattice.index(r.first / 4 * 4, j),
                              lattice.index(std::min(r.last / 4 * 4 + 4, lattice.nx), j)});
    }
    return ranges;
  }

private:
  /// Columns from the first to the last node.
  struct Part {
    int first = std::numeric_limits<int>::max();
    int last = -1;

    void extend(int from, int to) {
      first = std::min(first, from);
      last = std::max(last, to);
    }
  };
  struct Position {
    int level, row, column;
  };

  static int parts_per_row(const Lattice& lattice) { return (lattice.nx + tile_columns - 1) / tile_columns; }

  Part& part(int level, int row, int column) {
    return parts_[first_[static_cast<std::size_t>(level)] +
                  static_cast<std::size_t>(row * parts_per_row(ground_.lattice(level)) +
                                           column / tile_columns)];
  }

  Position position_of(std::size_t node) const {
    int level = 0;
    while (node >= ground_.lattice(level).first + ground_.lattice(level).count())
      ++level;
    const Lattice& lattice = ground_.lattice(level);
    const auto columns = static_cast<std::size_t>(lattice.nx);
    const std::size_t n = node - lattice.first;
    return {level, static_cast<int>(n / columns), static_cast<int>(n % columns)};
  }

  const Ground& ground_;
  std::vector<std::size_t> first_; ///< of each lattice
  std::vector<Part> parts_;
};

/// Nodes of a rank's own tiles in the windows of other ranks' tiles.
void touch_from_others(const Ground& ground, Rows& rows) {
  const RankShare& share = *ground.share;
  for (std::size_t tile = 0; tile < ground.tiles.count(); ++tile)
    if (share.is_mine(tile))
      for (const std::size_t other : ground.tiles.around(tile))
        if (share.deal.load[other] > 0 && !share.is_mine(other))
          rows.touch(ground.tiles.level_of(tile),
                     overlap(ground.tiles.owned(tile), ground.tiles.window(other)));
}

/// Images of soil nodes, and the originals of such images, to which others may add.
void touch_images(const Prolongation& images, Rows& rows) {
  for (std::size_t r = 0; r < images.tied_count(); ++r)
    if (rows.holds(images.tied(r)))
      rows.touch(images.row(r).front().node);
  for (std::size_t r = 0; r < images.tied_count(); ++r)
    if (rows.holds(images.row(r).front().node))
      rows.touch(images.tied(r));
}

} // namespace

std::vector<NodeRange> find_soil_rows(const Ground& ground, std::span<const std::size_t> shared_nodes) {
  Rows rows(ground);
  const bool has_images = !ground.mesh && ground.spec.periodic(); // they are nodes of soil too
  const bool whole = has_images && !ground.share;
  for (const Particles& set : ground.sets)
    for (std::size_t block = 0; block < ground.block_count(); ++block) {
      const int level = ground.level_of_block(block);
      for (std::size_t k = set.block_start[block]; k < set.block_start[block + 1]; ++k)
        rows.touch(level, reach_of(set, k, ground.sort_distance()), whole);
    }
  for (const ClockTiles& clock : ground.clock_tiles)
    for (const AcrossTile& tile : clock.across)
      for (const std::uint32_t four : tile.weights.fours())
        for (const std::uint32_t node : ground.basis_cells.four(four).node)
          rows.touch(node);
  if (ground.share)
    touch_from_others(ground, rows);
  for (const std::size_t node : shared_nodes)
    rows.touch(node);
  if (ground.mesh) {
    const Prolongation& ties = ground.mesh->prolongation();
    for (std::size_t r = 0; r < ties.tied_count(); ++r)
      if (rows.holds(ties.tied(r)))
        for (const Share& share : ties.row(r))
          rows.touch(share.node);
  }
  if (has_images && ground.share)
    touch_images(ground.images, rows);
  return rows.ranges();
}

std::vector<std::size_t> find_soil_ties(const Ground& ground) {
  const Prolongation& ties = ground.ties();
  std::vector<std::size_t> found(ties.tied_count());
  std::iota(found.begin(), found.end(), std::size_t{0});
  if (ground.mesh || ground.share || found.empty())
    return found;
  Rows rows(ground);
  const double way = ground.grid.h; // as in TileMap::window: no particle moves by more than a cell
  for (const Particles& set : ground.sets_of_soil())
    for (std::size_t k = 0; k < set.size(); ++k)
      rows.touch(0, reach_of(set, k, way), false);
  std::erase_if(found, [&](std::size_t r) { return !rows.holds(ties.tied(r)); });
  return found;
}

} // namespace tremolo::mpm_domain
