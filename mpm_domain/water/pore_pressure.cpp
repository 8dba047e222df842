#include "mpm_domain/water/pore_pressure.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/cell_means.hpp"
#include "mpm_domain/transfer/for_samples.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"
#include "mpm_domain/water/storage.hpp"

#include <numeric>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

bool is_wet(const Particles& p) {
  return p.traits.wet;
}

std::size_t number_of(const Domain& domain, const Particles& p) {
  return static_cast<std::size_t>(&p - domain.sets.data());
}

/// Adds up W and W dp of the particles of all cells, after `find(set, range or tile)` has found W dp.
/// @param of_tile    (set, range, tile) finds W dp of particles on one lattice
/// @param of_across  (set, tile) finds it of others
/// @param product    W dp of particle k of set s
template <typename OfTile, typename OfAcross, typename Product>
void sum_cells(Domain& domain, const OfTile& of_tile, const OfAcross& of_across, const Product& product) {
  clear_cells(domain);
  ClockTiles& tiles = domain.clock_tiles.front();
  tiles.sums.add_to(domain.grid, cell_sums, domain.tiles, domain.workers, domain.windows,
                    [&](std::size_t n, double* window) {
                      const std::size_t tile = tiles.sums.filled()[n];
                      const CellFinder finder(domain.tiles, tile);
                      const CellWindow sums(window);
                      for (std::size_t s = 0; s < domain.sets.size(); ++s) {
                        Particles& p = domain.sets[s];
                        const ParticleRange range = p.in_block(domain.block(0, tile));
                        if (!is_wet(p) || range.begin == range.end)
                          continue;
                        of_tile(s, range, tile);
                        for (std::size_t k = range.begin; k < range.end; ++k) {
                          const CellFinder::Cell cell = finder.at(p.x[k], p.y[k]);
                          domain.waiting_pressures[s].cell[k] = cell.node;
                          sums.add(cell.in_window, storage_of(p, k), product(s, k));
                        }
                      }
                      const NodeBlock place = domain.tiles.window(tile);
                      return RowRange{place.row, place.end_row()};
                    });
  domain.workers.run(tiles.across.size(), [&](std::size_t task) {
    const AcrossTile& tile = tiles.across[task];
    const Particles& p = domain.sets[tile.set];
    if (!is_wet(p))
      return;
    of_across(tile.set, tile);
    const CellFinder finder(*domain.mesh);
    for (std::size_t k = tile.weights.first(); k < tile.weights.end(); ++k)
      domain.waiting_pressures[tile.set].cell[k] = finder.at(p.x[k], p.y[k]).node;
  });
  complete_cells(domain, tiles, is_wet, [&](std::size_t s, std::size_t k) {
    return CellValues{domain.waiting_pressures[s].cell[k], storage_of(domain.sets[s], k), product(s, k)};
  });
}

/// C of -dt (K_f/n) theta.
template <bool remapped>
void compress(Domain& domain, double dt) {
  constexpr Wanted wanted{.gradient = true, .remapped = remapped};
  const auto take = [&](std::size_t s, const VelocityFields& velocities, const auto&... where) {
    const Particles& p = domain.sets[s];
    double* const compression = domain.waiting_pressures[s].compression.data();
    for_samples<wanted>(domain, p, where..., velocities, [&](std::size_t k, auto group, const Samples& q) {
      group.store(&compression[k], -dt * group.load(&p.volume[k]) * (q.vx_x + q.vy_y));
    });
  };
  // In a domain where water flows nowhere there is no flux but that of soil.
  const VelocityFields velocities = domain.has_flow() ? of_water(domain.grid) : of_soil(domain.grid);
  sum_cells(
      domain,
      [&](std::size_t s, const ParticleRange& range, std::size_t tile) { take(s, velocities, range, tile); },
      [&](std::size_t s, const AcrossTile& tile) { take(s, velocities, tile); },
      [&](std::size_t s, std::size_t k) { return domain.waiting_pressures[s].compression[k]; });
}

/// The mean at nodes, which A takes of the means of cells.
void average_at_nodes(Domain& domain, std::span<const NodeRange> nodes, std::span<const std::size_t> ties) {
  Grid& grid = domain.grid;
  const auto product = [&](const Particles& p, std::size_t k) {
    return storage_of(p, k) * mean_of_cell(grid, domain.waiting_pressures[number_of(domain, p)].cell[k]);
  };
  constexpr SumRange fields = sums_between(Sum::pressure_change, Sum::pressure_change);
  clear(domain, NodeGroup::pressure, nodes);
  for (const std::size_t row : ties)
    grid.pressure_change[domain.ties().tied(row)] = 0.0; // they hold the last means
  add_sums(
      domain, 0, fields,
      [&](const Particles& p, std::size_t tile, double* window) {
        if (!is_wet(p))
          return RowRange{};
        return scatter_scalars<1>(domain, p, 0, tile, window, Sum::pressure_change,
                                  [&](std::size_t k, auto group) {
                                    Lanes products{};
                                    for (std::size_t lane = 0; lane < group.count; ++lane)
                                      products[lane] = product(p, k + lane);
                                    return std::array{products};
                                  });
      },
      [&](AcrossTile& tile) {
        const Particles& p = domain.sets[tile.set];
        add_across_tile(tile, fields, [&](std::size_t k, const FourWeights& w, const auto& add) {
          if (is_wet(p))
            add(fields.first, product(p, k) * w.s);
        });
      });
  fold(domain, NodeGroup::pressure, ties);
  domain.workers.run(nodes.size(), [&](std::size_t row) {
    by_fours(nodes[row].begin, nodes[row].end, [&](std::size_t n, auto group) {
      const Lanes storage = group.load(&grid.storage[n]);
      group.store(&grid.pressure_change[n],
                  group.load(&grid.pressure_change[n]) * inverse(storage, storage > 0.0));
    });
  });
  prolong(domain, NodeGroup::pressure, ties);
}

/// C of what particles read from the nodes.
void average_again(Domain& domain) {
  const NodeField& mean = domain.grid.pressure_change;
  const auto keep = [&](std::size_t s) {
    return [to = domain.waiting_pressures[s].change.data()](std::size_t k, auto group, const Lanes& change) {
      group.store(&to[k], change);
    };
  };
  sum_cells(
      domain,
      [&](std::size_t s, const ParticleRange& range, std::size_t tile) {
        for_numbers(domain, domain.sets[s], range, tile, mean, keep(s));
      },
      [&](std::size_t s, const AcrossTile& tile) { for_numbers(tile, mean, keep(s)); },
      [&](std::size_t s, std::size_t k) {
        return storage_of(domain.sets[s], k) * domain.waiting_pressures[s].change[k];
      });
}

/// Adds the increments to the pressures; returns the work by the trapezoidal rule.
double add_increments(Domain& domain) {
  std::vector<double> works(domain.sets.size());
  domain.workers.run(works.size(), [&](std::size_t s) {
    Particles& p = domain.sets[s];
    if (!is_wet(p))
      return;
    const WaitingPressures& waiting = domain.waiting_pressures[s];
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double before = p.water->excess(p.pore_pressure[k], p.y[k]);
      p.pore_pressure[k] += mean_of_cell(domain.grid, waiting.cell[k]);
      const double after = p.water->excess(p.pore_pressure[k], p.y[k]);
      works[s] += 0.5 * (before + after) * waiting.compression[k];
    }
  });
  return std::accumulate(works.begin(), works.end(), 0.0);
}

} // namespace

double update_pressures(Domain& domain, double dt, bool remapped, std::span<const NodeRange> nodes,
                        std::span<const std::size_t> ties) {
  for (std::size_t s = 0; s < domain.sets.size(); ++s)
    if (is_wet(domain.sets[s]))
      domain.waiting_pressures[s].resize(domain.sets[s].size());
  // The flux is that which strains, whether remapped or not.
  remapped || domain.has_flow() ? compress<true>(domain, dt) : compress<false>(domain, dt);
  average_at_nodes(domain, nodes, ties);
  average_again(domain);
  return add_increments(domain);
}

} // namespace tremolo::mpm_domain
