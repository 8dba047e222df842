#include "mpm_domain/grid/soil_rows.hpp"

#include "mpm_domain/domain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace tremolo::mpm_domain {

namespace {

/// Marks nodes, row by row.
class Rows {
public:
  explicit Rows(const Domain& domain) : domain_(domain) {
    for (int level = 0; level < domain.lattice_count(); ++level) {
      first_row_.push_back(rows_.size());
      rows_.resize(rows_.size() + static_cast<std::size_t>(domain.lattice(level).ny));
    }
  }

  /// Nodes that a box touches on a lattice.
  /// @param whole  take whole rows
  void touch(int level, const mesh::Rectangle& box, bool whole) {
    const Lattice& lattice = domain_.lattice(level);
    const auto cell = [&](double x, double x0) { return static_cast<int>(std::floor((x - x0) / lattice.h)); };
    const int first = whole ? 0 : cell(box.x_min, lattice.x0);
    const int last = whole ? lattice.nx - 1 : cell(box.x_max, lattice.x0) + 1;
    for (int j = std::max(0, cell(box.y_min, lattice.y0));
         j <= std::min(lattice.ny - 1, cell(box.y_max, lattice.y0) + 1); ++j)
      extend(level, static_cast<std::size_t>(j), first, last);
  }

  bool holds(std::size_t node) const {
    const auto [level, row, column] = place_of(node);
    const Row& r = rows_[first_row_[static_cast<std::size_t>(level)] + row];
    return r.first <= column && column <= r.last;
  }

  void touch(std::size_t node) {
    const auto [level, row, column] = place_of(node);
    extend(level, row, column, column);
  }

  std::vector<NodeRange> ranges() const {
    std::vector<NodeRange> ranges;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      if (rows_[r].last < rows_[r].first)
        continue;
      const NodeRange all = domain_.row(r);
      const auto first = static_cast<std::size_t>(std::max(0, rows_[r].first)) / 4 * 4;
      const auto end = static_cast<std::size_t>(rows_[r].last) / 4 * 4 + 4;
      ranges.push_back({all.begin + first, std::min(all.begin + end, all.end)});
    }
    return ranges;
  }

private:
  /// Columns from the first to the last node.
  struct Row {
    int first = std::numeric_limits<int>::max();
    int last = -1;
  };
  struct Place {
    int level;
    std::size_t row;
    int column;
  };

  void extend(int level, std::size_t row, int first, int last) {
    Row& r = rows_[first_row_[static_cast<std::size_t>(level)] + row];
    r = {std::min(r.first, first), std::max(r.last, last)};
  }

  Place place_of(std::size_t node) const {
    int level = 0;
    while (node >= domain_.lattice(level).first + domain_.lattice(level).count())
      ++level;
    const Lattice& lattice = domain_.lattice(level);
    const auto columns = static_cast<std::size_t>(lattice.nx);
    return {level, (node - lattice.first) / columns, static_cast<int>((node - lattice.first) % columns)};
  }

  const Domain& domain_;
  std::vector<std::size_t> first_row_; ///< of each lattice
  std::vector<Row> rows_;
};

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
