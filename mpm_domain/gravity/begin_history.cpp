#include "mpm_domain/gravity/begin_history.hpp"

#include "mpm_domain/tiles/cell_means.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// Excess pressures are means of cells, and so is the stress that pore pressure ratios are taken over.
void keep_vertical_stress(Domain& domain) {
  const CellFinder finder = domain.mesh ? CellFinder(*domain.mesh) : CellFinder(domain.tiles, 0);
  const auto over_wet = [&](const auto& act) {
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
        act(set, k, finder.at(set.x[k], set.y[k]).node);
  };
  clear_cells(domain);
  over_wet([&](const Particles& set, std::size_t k, std::size_t cell) {
    domain.grid.cell_weight[cell] += set.volume[k];
    domain.grid.cell_change[cell] += set.volume[k] * set.syy[k];
  });
  join_images_of_cells(domain);
  over_wet([&](Particles& set, std::size_t k, std::size_t cell) {
    set.vertical_at_rest[k] = mean_of_cell(domain.grid, cell);
  });
}

void add_cut(std::vector<CutStress>& cut, const std::string& soil, Vector at) {
  auto of = std::ranges::find(cut, soil, &CutStress::soil);
  if (of == cut.end())
    of = cut.insert(of, {soil, 0, at, at});
  ++of->particles;
  of->low = {std::min(of->low.x, at.x), std::min(of->low.y, at.y)};
  of->high = {std::max(of->high.x, at.x), std::max(of->high.y, at.y)};
}

} // namespace

std::vector<CutStress> begin_history(Domain& domain) {
  std::vector<CutStress> cut;
  for (Particles& set : domain.sets) {
    const std::vector<double> before[] = {set.sxx, set.syy, set.sxy};
    materials::initialise(set.law, set.points(0, set.size()));
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double change = std::abs(set.sxx[k] - before[0][k]) + std::abs(set.syy[k] - before[1][k]) +
                            std::abs(set.sxy[k] - before[2][k]);
      if (change > 1e-3 * (std::abs(before[0][k]) + std::abs(before[1][k])))
        add_cut(cut, set.soil, {set.x[k], set.y[k]});
    }
  }
  keep_vertical_stress(domain);
  domain.boundary.match(domain);
  return cut;
}

} // namespace tremolo::mpm_domain
