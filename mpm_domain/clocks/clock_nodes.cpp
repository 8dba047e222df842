#include "mpm_domain/clocks/clock_nodes.hpp"

#include "mpm_domain/tiles/totals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// First and last node along an axis whose hat functions a box can touch.
struct Reach {
  int first;
  int last;

  Reach(double low, double high, double origin, double h)
      : first(static_cast<int>(std::floor((low - origin) / h))),
        last(static_cast<int>(std::floor((high - origin) / h)) + 1) {}
  bool operator==(const Reach&) const = default;
};

} // namespace

/// Marks what particles touch.
class ClockNodes::Builder {
public:
  Builder(const Ground& ground, ClockNodes& nodes)
      : ground_(ground), prolongation_(ground.ties()), nodes_(nodes),
        tied_seen_(nodes.ties_.size() * prolongation_.tied_count(), false) {}

  /// Particles of a block on one lattice.
  void touch_block(const Particles& set, std::size_t block) {
    const Lattice& lattice = ground_.lattice(ground_.level_of_block(block));
    const int clock = ground_.clock_of_block(block);
    std::optional<Reach> last_x, last_y;
    for (std::size_t k = set.block_start[block]; k < set.block_start[block + 1]; ++k) {
      const mesh::Rectangle box = reach_of(set, k, ground_.sort_distance());
      const Reach x(box.x_min, box.x_max, lattice.x0, lattice.h);
      const Reach y(box.y_min, box.y_max, lattice.y0, lattice.h);
      if (last_x == x && last_y == y)
        continue;
      last_x = x;
      last_y = y;
      for (int j = y.first; j <= y.last; ++j)
        for (int i = x.first; i <= x.last; ++i)
          touch(lattice.index(i, j), clock);
    }
  }

  /// Particles of a block across several.
  void touch_across(const Particles& set, std::size_t block) {
    const int clock = ground_.clock_of_block(block);
    const GradedMesh& mesh = *ground_.mesh;
    for (std::size_t k = set.block_start[block]; k < set.block_start[block + 1]; ++k)
      mesh.for_parts(reach_of(set, k, ground_.sort_distance()),
                     [&](const mesh::Cell& cell, const mesh::Rectangle&) {
                       for (const int corner : {0, 1, 2, 3})
                         touch(mesh.node(cell.level, cell.i + corner % 2, cell.j + corner / 2), clock);
                     });
  }

private:
  void touch(std::size_t node, int clock) {
    const std::optional<std::size_t> row = prolongation_.row_of(node);
    if (!row)
      return take(node, clock);
    const auto c = static_cast<std::size_t>(clock);
    const std::size_t seen = c * prolongation_.tied_count() + *row;
    if (tied_seen_[seen])
      return;
    tied_seen_[seen] = true;
    nodes_.ties_[c].push_back(*row);
    for (const Share& share : prolongation_.row(*row))
      take(share.node, clock);
  }

  void take(std::size_t node, int clock) {
    const auto number = static_cast<std::uint32_t>(clock + 1);
    std::uint32_t& fastest = nodes_.clock_[node];
    std::uint32_t& slowest = nodes_.slowest_[node];
    slowest = fastest == 0 ? number : std::min(slowest, number);
    fastest = std::max(fastest, number);
  }

  const Ground& ground_;
  const Prolongation& prolongation_;
  ClockNodes& nodes_;
  std::vector<bool> tied_seen_; ///< by clock and row of the prolongation
};

ClockNodes::ClockNodes(const Ground& ground) : ties_(static_cast<std::size_t>(ground.clocks.count())) {
  if (ground.clocks.count() == 1) {
    of_ = from_ = {ground.soil_rows};
    shared_.resize(1);
    ties_.front() = ground.soil_ties;
    return;
  }
  clock_.assign(ground.grid.size(), 0);
  slowest_.assign(ground.grid.size(), 0);
  Builder builder(ground, *this);
  for (const Particles& set : ground.sets) {
    for (std::size_t block = 0; block < ground.block_count(); ++block)
      builder.touch_block(set, block);
    for (std::size_t block = 0; block < ground.across_block_count(); ++block)
      builder.touch_across(set, ground.block_count() + block);
  }
  for (std::vector<std::size_t>& rows : ties_)
    std::ranges::sort(rows);
  take_clocks_of_all(ground);
  collect(ground);
}

/// Ranks that share the ground compute nodes, at the boundary, that only particles of others touch.
void ClockNodes::take_clocks_of_all(const Ground& ground) {
  if (!ground.share)
    return;
  const auto beyond_all = static_cast<std::uint32_t>(ties_.size() + 1);
  std::vector<double> largest;
  for (std::size_t n = 0; n < clock_.size(); ++n)
    for (const std::uint32_t number : {clock_[n], slowest_[n] > 0 ? beyond_all - slowest_[n] : 0U})
      largest.push_back(number);
  take_largest(ground, largest);
  for (std::size_t n = 0; n < clock_.size(); ++n) {
    clock_[n] = static_cast<std::uint32_t>(largest[2 * n]);
    slowest_[n] = clock_[n] > 0 ? beyond_all - static_cast<std::uint32_t>(largest[2 * n + 1]) : 0U;
  }
}

void ClockNodes::require_fit(const Ground& ground) const {
  const std::size_t nodes = ground.grid.size();
  const std::size_t rows = ground.ties().tied_count();
  const auto beyond = [rows](const std::vector<std::size_t>& ties) {
    return std::ranges::any_of(ties, [rows](std::size_t row) { return row >= rows; });
  };
  if (clock_.size() != nodes || slowest_.size() != nodes || std::ranges::any_of(ties_, beyond))
    throw std::runtime_error(
        fmt::format("the clocks of {} nodes are not those of a grid of {} nodes, {} of them tied",
                    clock_.size(), nodes, rows));
}

void ClockNodes::collect(const Ground& ground) {
  const std::size_t clocks = ties_.size();
  of_.assign(clocks, {});
  from_.assign(clocks, {});
  shared_.assign(clocks, {});
  const auto add_runs = [&](const NodeRange& row, const auto& wanted, std::vector<NodeRange>& runs) {
    for (std::size_t n = row.begin; n < row.end; ++n) {
      const std::size_t begin = n;
      while (n < row.end && wanted(n))
        ++n;
      if (n > begin)
        runs.push_back({begin, n});
    }
  };
  for (const NodeRange& row : ground.soil_rows)
    for (std::size_t clock = 0; clock < clocks; ++clock) {
      add_runs(
          row, [&](std::size_t n) { return clock_[n] == clock + 1; }, of_[clock]);
      add_runs(
          row, [&](std::size_t n) { return clock_[n] >= clock + 1; }, from_[clock]);
      add_runs(
          row, [&](std::size_t n) { return clock_[n] > clock + 1 && slowest_[n] <= clock + 1; },
          shared_[clock]);
    }
}

} // namespace tremolo::mpm_domain
