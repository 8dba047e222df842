#include "mpm_domain/dispersion/fullness.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/kernel/lanes.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

double lightest_soil(const Ground& ground) {
  double density = std::numeric_limits<double>::infinity();
  for (const Particles& set : ground.sets)
    if (!set.index_of.empty())
      density = std::min(density, set.density);
  return density;
}

void find_fullness(Ground& ground, const NodeRange& nodes, double per_full) {
  Grid& grid = ground.grid;
  by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
    group.store(&grid.fullness[n], smaller(all(1.0), per_full * group.load(&grid.mass[n])));
  });
}

void find_inside(Ground& ground, const NodeRange& nodes) {
  Grid& grid = ground.grid;
  const auto row = static_cast<std::ptrdiff_t>(grid.nx);
  by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
    const double* const e = &grid.fullness[n];
    const auto at = [&](std::ptrdiff_t node) { return group.load(e + node); };
    const Lanes here = at(0);
    group.store(&grid.inside_x[n], smaller(here, smaller(at(-1), at(1))));
    group.store(&grid.inside_y[n], smaller(here, smaller(at(-row), at(row))));
    Lanes around = here;
    for (std::ptrdiff_t j = -1; j < 2; ++j)
      for (std::ptrdiff_t i = -1; i < 2; ++i)
        around = smaller(around, at(j * row + i));
    group.store(&grid.inside_both[n], around);
    Lanes least = here;
    for (std::ptrdiff_t j = 0; j < 4; ++j)
      for (std::ptrdiff_t i = 0; i < 4; ++i)
        least = smaller(least, at(j * row + i));
    group.store(&grid.inside_block[n], choose(least < 1.0, Lanes{}, all(1.0)));
  });
}

} // namespace

void find_fullness(Ground& ground) {
  const double h = ground.grid.h;
  constexpr double full = 0.45; // of a cell
  const double per_full = 1.0 / (full * lightest_soil(ground) * h * h);
  const std::vector<NodeRange>& rows = ground.soil_rows;
  ground.workers.run(rows.size(), [&](std::size_t r) { find_fullness(ground, rows[r], per_full); });
  prolong(ground, NodeGroup::fullness);
  take_at_skirt(ground, std::array{&NodeFields::fullness});
  const std::size_t reach = 3 * (static_cast<std::size_t>(ground.grid.nx) + 1);
  ground.workers.run(rows.size(), [&](std::size_t r) {
    if (rows[r].begin >= reach && rows[r].end + reach <= ground.grid.size())
      find_inside(ground, rows[r]);
  });
}

} // namespace tremolo::mpm_domain
