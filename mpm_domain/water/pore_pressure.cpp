#include "mpm_domain/water/pore_pressure.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/particles/water/pore_volume.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/tiles/cell_means.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/for_samples.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

WaitingPressures& waiting_of(Ground& ground, const Particles& p) {
  return ground.waiting_pressures[static_cast<std::size_t>(&p - ground.sets.data())];
}

void find_cells(const Particles& p, std::size_t begin, std::size_t end, const CellFinder& finder,
                WaitingPressures& waiting) {
  for (std::size_t k = begin; k < end; ++k) {
    const CellFinder::Cell cell = finder.at(p.x[k], p.y[k]);
    waiting.cell[k] = cell.node;
    waiting.in_window[k] = static_cast<std::uint32_t>(cell.in_window);
  }
}

/// The mean e of every cell, sum W e/sum W of its wet particles, which stands in cell_change then.
/// @param of_tile    (set, range, tile) finds W e of particles on one lattice and their cells
/// @param of_across  (set, tile) does so for others
/// @param product    W e of particle k of set s
template <typename OfTile, typename OfAcross, typename Product>
void average_in_cells(Ground& ground, const OfTile& of_tile, const OfAcross& of_across,
                      const Product& product) {
  clear_cells(ground);
  ClockTiles& tiles = ground.clock_tiles.front();
  tiles.sums.add_to(ground.grid, cell_sums, ground.tiles, ground.workers, ground.windows,
                    [&](std::size_t n, double* window) {
                      const std::size_t tile = tiles.sums.filled()[n];
                      const CellWindow sums(window);
                      bool any = false;
                      for (std::size_t s = 0; s < ground.sets.size(); ++s) {
                        const Particles& p = ground.sets[s];
                        const ParticleRange range = p.in_block(ground.block(0, tile));
                        if (!takes_pressure(p) || range.begin == range.end)
                          continue;
                        any = true;
                        of_tile(s, range, tile);
                        const std::uint32_t* const cell = ground.waiting_pressures[s].in_window.data();
                        for (std::size_t k = range.begin; k < range.end; ++k)
                          sums.add(cell[k], pore_volume(p, k), product(s, k));
                      }
                      const NodeBlock position = ground.tiles.window(tile);
                      return any ? RowRange{position.row, position.end_row()} : RowRange{};
                    });
  ground.workers.run(tiles.across.size(), [&](std::size_t task) {
    const AcrossTile& tile = tiles.across[task];
    if (takes_pressure(ground.sets[tile.set]))
      of_across(tile.set, tile);
  });
  complete_cells(ground, tiles, takes_pressure, [&](std::size_t s, std::size_t k) {
    return CellValues{ground.waiting_pressures[s].cell[k], pore_volume(ground.sets[s], k), product(s, k)};
  });
  Grid& grid = ground.grid;
  ground.workers.run(ground.row_count(), [&](std::size_t row) {
    const NodeRange nodes = ground.row(row);
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const Lanes weight = group.load(&grid.cell_weight[n]);
      group.store(&grid.cell_change[n], group.load(&grid.cell_change[n]) * inverse(weight, weight > 0.0));
    });
  });
}

/// C of e = -dt theta/n.
/// @param flux_x,flux_y  v_s + n w
void compress(Ground& ground, double dt, const NodeField& flux_x, const NodeField& flux_y) {
  const auto keep = [&](std::size_t s) {
    return [&p = ground.sets[s], to = ground.waiting_pressures[s].compression.data(),
            dt](std::size_t k, auto group, const Lanes& divergence) {
      group.store(&to[k], -dt * group.load(&p.volume[k]) * divergence);
    };
  };
  average_in_cells(
      ground,
      [&](std::size_t s, const ParticleRange& range, std::size_t tile) {
        const Particles& p = ground.sets[s];
        for_divergences(ground, p, range, tile, flux_x, flux_y, keep(s));
        find_cells(p, range.begin, range.end, CellFinder(ground.tiles, tile), ground.waiting_pressures[s]);
      },
      [&](std::size_t s, const AcrossTile& tile) {
        for_divergences(tile, flux_x, flux_y, keep(s));
        find_cells(ground.sets[s], tile.weights.first(), tile.weights.end(), CellFinder(*ground.mesh),
                   ground.waiting_pressures[s]);
      },
      [&](std::size_t s, std::size_t k) { return ground.waiting_pressures[s].compression[k]; });
}

/// The means of the cells of a group of particles.
template <typename Group>
Lanes means_of_cells(const Grid& grid, const WaitingPressures& waiting, std::size_t k, Group group) {
  const std::size_t* const cell = waiting.cell.data() + k;
  Lanes mean{};
  for (std::size_t lane = 0; lane < group.count; ++lane)
    mean[lane] = grid.cell_change[cell[lane]];
  return mean;
}

/// W e of a group of wet particles.
template <typename Group>
Lanes compression_of(Ground& ground, const Particles& p, std::size_t k, Group group) {
  return pore_volume(p, k, group) * means_of_cells(ground.grid, waiting_of(ground, p), k, group);
}

/// The mean at nodes, which A takes of the means of cells.
void average_at_nodes(Ground& ground, std::span<const NodeRange> nodes, std::span<const std::size_t> ties) {
  Grid& grid = ground.grid;
  constexpr std::array fields{sums_between(Sum::compression, Sum::compression)};
  clear(ground, NodeGroup::compression, nodes);
  for (const std::size_t row : ties)
    grid.compression[ground.ties().tied(row)] = 0.0; // they hold the last means
  add_sums(
      ground, 0, fields,
      [&](const Particles& p, std::size_t tile, double* window) {
        if (!takes_pressure(p))
          return RowRange{};
        return scatter_scalars<1>(
            ground, p, 0, tile, window, Sum::compression,
            [&](std::size_t k, auto group) { return std::array{compression_of(ground, p, k, group)}; });
      },
      [&](AcrossTile& tile) {
        const Particles& p = ground.sets[tile.set];
        add_across_tile(tile, fields.front(), [&](std::size_t k, const FourWeights& w, const auto& add) {
          if (takes_pressure(p))
            add(fields.front().first, compression_of(ground, p, k, FewerThanFour(1))[0] * w.s);
        });
      });
  fold(ground, NodeGroup::compression, ties);
  ground.workers.run(nodes.size(), [&](std::size_t row) {
    by_fours(nodes[row].begin, nodes[row].end, [&](std::size_t n, auto group) {
      const Lanes volume = group.load(&grid.pore_volume[n]);
      group.store(&grid.compression[n], group.load(&grid.compression[n]) * inverse(volume, volume > 0.0));
    });
  });
  prolong(ground, NodeGroup::compression, ties);
}

/// C of the excess pressures, which take up K_f times what particles read from the nodes.
void average_again(Ground& ground) {
  const NodeField& mean = ground.grid.compression;
  const auto keep = [&](std::size_t s) {
    return [to = ground.waiting_pressures[s].change.data()](std::size_t k, auto group, const Lanes& change) {
      group.store(&to[k], change);
    };
  };
  average_in_cells(
      ground,
      [&](std::size_t s, const ParticleRange& range, std::size_t tile) {
        for_numbers(ground, ground.sets[s], range, tile, mean, keep(s));
      },
      [&](std::size_t s, const AcrossTile& tile) { for_numbers(tile, mean, keep(s)); },
      [&](std::size_t s, std::size_t k) {
        const Particles& p = ground.sets[s];
        const double excess = p.pore_pressure[k] - rest_pressure(p, k);
        return pore_volume(p, k) *
               (excess + p.water->fluid.bulk_modulus * ground.waiting_pressures[s].change[k]);
      });
}

/// Gives a range the pressures of its cells; returns the work by the trapezoidal rule.
double take_pressures(Ground& ground, Particles& p, std::size_t begin, std::size_t end) {
  const WaitingPressures& waiting = waiting_of(ground, p);
  const Lanes least = all(p.water->fluid.cavitation_pressure);
  Lanes work{};
  by_fours(begin, end, [&](std::size_t k, auto group) {
    const Lanes before = group.load(&p.pore_pressure[k]);
    const Lanes at_rest = rest_pressure(p, k, group);
    const Lanes after = at_rest + means_of_cells(ground.grid, waiting, k, group);
    group.store(&p.pore_pressure[k], after);
    work += (0.5 * (larger(before, least) + larger(after, least)) - at_rest) *
            group.load(&waiting.compression[k]);
  });
  return sum(work);
}

/// Updates the pressures of all particles of this rank. Sums are split by tiles, which do not depend on the
/// number of ranks.
ExactSums<1> take_pressures(Ground& ground) {
  const std::size_t blocks = ground.block_count() + ground.across_block_count();
  std::vector<std::array<double, 1>> works(blocks);
  ground.workers.run(blocks, [&](std::size_t block) {
    for (Particles& p : ground.sets)
      if (takes_pressure(p)) {
        const ParticleRange range = p.in_block(block);
        works[block][0] += take_pressures(ground, p, range.begin, range.end);
      }
  });
  return sums_of(std::span<const std::array<double, 1>>(works));
}

} // namespace

ExactSums<1> update_pressures(Ground& ground, double dt, const NodeField& flux_x, const NodeField& flux_y,
                              std::span<const NodeRange> nodes, std::span<const std::size_t> ties) {
  for (std::size_t s = 0; s < ground.sets.size(); ++s)
    if (takes_pressure(ground.sets[s]))
      ground.waiting_pressures[s].resize(ground.sets[s].size());
  compress(ground, dt, flux_x, flux_y);
  average_at_nodes(ground, nodes, ties);
  average_again(ground);
  return take_pressures(ground);
}

} // namespace tremolo::mpm_domain
