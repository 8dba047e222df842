#include "mpm_domain/grid/soil_rows.hpp"

#include "mpm_domain/domain.hpp"

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
  explicit Rows(const Domain& domain) : domain_(domain) {
    for (int level = 0; level < domain.lattice_count(); ++level) {
      first_.push_back(parts_.size());
      const Lattice& lattice = domain.lattice(level);
      parts_.resize(parts_.size() +
                    static_cast<std::size_t>(parts_per_row(lattice)) * static_cast<std::size_t>(lattice.ny));
    }
  }

  /// Nodes that a box touches on a lattice.
  /// @param whole  take whole rows
  void touch(int level, const mesh::Rectangle& box, bool whole) {
    const Lattice& lattice = domain_.lattice(level);
    const auto cell = [&](double x, double x0) { return static_cast<int>(std::floor((x - x0) / lattice.h)); };
    const int first = whole ? 0 : cell(box.x_min, lattice.x0);
    const int last = whole ? lattice.nx - 1 : cell(box.x_max, lattice.x0) + 1;
    const int low = cell(box.y_min, lattice.y0);
    touch(level, {first, low, last - first + 1, cell(box.y_max, lattice.y0) + 2 - low});
  }

  void touch(int level, const NodeBlock& nodes) {
    const Lattice& lattice = domain_.lattice(level);
    const NodeBlock inside = overlap(nodes, {0, 0, lattice.nx, lattice.ny});
    for (int j = inside.row; j < inside.end_row(); ++j)
      for (int i = inside.column; i < inside.end_column(); i = (i / tile_columns + 1) * tile_columns)
        part(level, j, i).extend(i, std::min(inside.end_column(), (i / tile_columns + 1) * tile_columns) - 1);
  }

  void touch(std::size_t node) {
    const auto [level, row, column] = place_of(node);
    part(level, row, column).extend(column, column);
  }

  bool holds(std::size_t node) {
    const auto [level, row, column] = place_of(node);
    const Part& r = part(level, row, column);
    return r.first <= column && column <= r.last;
  }

  std::vector<NodeRange> ranges() const {
    std::vector<NodeRange> ranges;
    std::size_t p = 0;
    for (int level = 0; level < domain_.lattice_count(); ++level) {
      const Lattice& lattice = domain_.lattice(level);
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
  struct Place {
    int level, row, column;
  };

  static int parts_per_row(const Lattice& lattice) { return (lattice.nx + tile_columns - 1) / tile_columns; }

  Part& part(int level, int row, int column) {
    return parts_[first_[static_cast<std::size_t>(level)] +
                  static_cast<std::size_t>(row * parts_per_row(domain_.lattice(level)) +
                                           column / tile_columns)];
  }

  Place place_of(std::size_t node) const {
    int level = 0;
    while (node >= domain_.lattice(level).first + domain_.lattice(level).count())
      ++level;
    const Lattice& lattice = domain_.lattice(level);
    const auto columns = static_cast<std::size_t>(lattice.nx);
    const std::size_t n = node - lattice.first;
    return {level, static_cast<int>(n / columns), static_cast<int>(n % columns)};
  }

  const Domain& domain_;
  std::vector<std::size_t> first_; ///< of each lattice
  std::vector<Part> parts_;
};

/// Nodes of a rank's own tiles in the windows of other ranks' tiles.
void touch_from_others(const Domain& domain, Rows& rows) {
  const RankShare& share = *domain.share;
  for (std::size_t tile = 0; tile < domain.tiles.count(); ++tile)
    if (share.is_mine(tile))
      for (const std::size_t other : domain.tiles.around(tile))
        if (share.deal.particles[other] > 0 && !share.is_mine(other))
          rows.touch(0, overlap(domain.tiles.owned(tile), domain.tiles.window(other)));
}

} // namespace

std::vector<NodeRange> find_soil_rows(const Domain& domain) {
  Rows rows(domain);
  const bool whole = !domain.mesh && domain.spec.periodic(); // images are nodes of soil too
  for (const Particles& set : domain.sets)
    for (std::size_t block = 0; block < domain.block_count(); ++block) {
      const int level = domain.level_of_block(block);
      for (std::size_t k = set.block_start[block]; k < set.block_start[block + 1]; ++k)
        rows.touch(level, reach_of(set, k, domain.sort_distance()), whole);
    }
  for (const ClockTiles& clock : domain.clock_tiles)
    for (const AcrossTile& tile : clock.across)
      for (const std::uint32_t four : tile.weights.fours())
        for (const std::uint32_t node : domain.basis_cells.four(four).node)
          rows.touch(node);
  if (domain.share) {
    touch_from_others(domain, rows);
    for (const std::size_t node : domain.boundary.shared_nodes())
      rows.touch(node);
  }
  if (domain.mesh) {
    const Prolongation& ties = domain.mesh->prolongation();
    for (std::size_t r = 0; r < ties.tied_count(); ++r)
      if (rows.holds(ties.tied(r)))
        for (const Share& share : ties.row(r))
          rows.touch(share.node);
  }
  return rows.ranges();
}

std::vector<std::size_t> find_soil_ties(const Domain& domain) {
  const Prolongation& ties = domain.ties();
  std::vector<std::size_t> found(ties.tied_count());
  std::iota(found.begin(), found.end(), std::size_t{0});
  if (domain.mesh || found.empty())
    return found;
  Rows rows(domain);
  const double way = domain.grid.h; // as in TileMap::window: no particle moves by more than a cell
  for (const Particles& set : domain.sets_of_soil())
    for (std::size_t k = 0; k < set.size(); ++k)
      rows.touch(0, reach_of(set, k, way), false);
  std::erase_if(found, [&](std::size_t r) { return !rows.holds(ties.tied(r)); });
  return found;
}

} // namespace tremolo::mpm_domain
