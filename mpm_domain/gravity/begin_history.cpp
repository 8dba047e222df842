#include "mpm_domain/gravity/begin_history.hpp"

#include "mpm_domain/particles/bounds.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/tiles/cell_means.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tremolo::mpm_domain {

namespace {

/// Excess pressures are means of cells, and so is the stress that pore pressure ratios are taken over.
void keep_vertical_stress(Domain& domain) {
  if (!domain.has_pore_pressure())
    return;
  const auto is_wet = [](const Particles& set) { return set.traits.wet; };
  ClockTiles& tiles = domain.clock_tiles.front(); // where there is water there is one clock
  clear_cells(domain);
  tiles.sums.add_to(domain.grid, cell_sums, domain.tiles, domain.workers, domain.windows,
                    [&](std::size_t n, double* window) {
                      const std::size_t tile = tiles.sums.filled()[n];
                      const CellFinder finder(domain.tiles, tile);
                      const CellWindow sums(window);
                      for (const Particles& set : domain.sets)
                        if (is_wet(set))
                          for (auto [k, end] = set.in_block(domain.block(0, tile)); k < end; ++k)
                            sums.add(finder.at(set.x[k], set.y[k]).in_window, set.volume[k],
                                     set.volume[k] * set.syy[k]);
                      return rows_of_window(domain, tile);
                    });
  const CellFinder finder = domain.mesh ? CellFinder(*domain.mesh) : CellFinder(domain.tiles, 0);
  complete_cells(domain, tiles, is_wet, [&](std::size_t s, std::size_t k) {
    const Particles& set = domain.sets[s];
    return CellValues{finder.at(set.x[k], set.y[k]).node, set.volume[k], set.volume[k] * set.syy[k]};
  });
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; is_wet(set) && k < set.size(); ++k)
      set.vertical_at_rest[k] = mean_of_cell(domain.grid, finder.at(set.x[k], set.y[k]).node);
}

/// Particles of a set whose stress was cut, and the corners of the box around them.
struct CutOfSet {
  std::int64_t particles = 0;
  double x_min = around_nothing.x_min, y_min = around_nothing.y_min;
  double x_max = around_nothing.x_max, y_max = around_nothing.y_max;

  void add(double x, double y) {
    ++particles;
    x_min = std::min(x_min, x);
    y_min = std::min(y_min, y);
    x_max = std::max(x_max, x);
    y_max = std::max(y_max, y);
  }
};

void take_cut_of_all(Communicator& ranks, std::vector<CutOfSet>& cut) {
  std::vector<std::int64_t> particles;
  std::vector<double> corners;
  for (const CutOfSet& of : cut) {
    particles.push_back(of.particles);
    corners.insert(corners.end(), {-of.x_min, -of.y_min, of.x_max, of.y_max});
  }
  ranks.add_and_find_largest(particles, corners);
  for (std::size_t s = 0; s < cut.size(); ++s)
    cut[s] = {particles[s], -corners[4 * s], -corners[4 * s + 1], corners[4 * s + 2], corners[4 * s + 3]};
}

/// The memory of the laws of a set begins.
CutOfSet begin_history(Particles& set) {
  CutOfSet cut;
  const std::vector<double> before[] = {set.sxx, set.syy, set.sxy};
  materials::initialise(set.law, set.points(0, set.size()));
  for (std::size_t k = 0; k < set.size(); ++k) {
    const double change = std::abs(set.sxx[k] - before[0][k]) + std::abs(set.syy[k] - before[1][k]) +
                          std::abs(set.sxy[k] - before[2][k]);
    if (change > 1e-3 * (std::abs(before[0][k]) + std::abs(before[1][k])))
      cut.add(set.x[k], set.y[k]);
  }
  return cut;
}

/// Puts the sets of each soil together, in their order.
std::vector<CutStress> by_soil(const std::vector<Particles>& sets, const std::vector<CutOfSet>& cut) {
  std::vector<CutStress> soils;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const auto& [particles, x_min, y_min, x_max, y_max] = cut[s];
    if (particles == 0)
      continue;
    auto of = std::ranges::find(soils, sets[s].soil, &CutStress::soil);
    if (of == soils.end())
      of = soils.insert(of, {sets[s].soil, 0, {x_min, y_min}, {x_max, y_max}});
    of->particles += static_cast<std::size_t>(particles);
    of->low = {std::min(of->low.x, x_min), std::min(of->low.y, y_min)};
    of->high = {std::max(of->high.x, x_max), std::max(of->high.y, y_max)};
  }
  return soils;
}

} // namespace

std::vector<CutStress> begin_history(Domain& domain) {
  std::vector<CutOfSet> cut;
  for (Particles& set : domain.sets)
    cut.push_back(begin_history(set));
  if (domain.share)
    take_cut_of_all(*domain.share->ranks, cut);
  keep_vertical_stress(domain);
  domain.boundary.match(domain);
  if (domain.share)
    follow_faces(domain);
  return by_soil(domain.sets, cut);
}

} // namespace tremolo::mpm_domain
