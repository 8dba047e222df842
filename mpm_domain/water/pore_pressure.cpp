#include "mpm_domain/water/pore_pressure.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/particles/water/pore_volume.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/tiles/cell_means.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/for_samples.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// Values of nodes in the window of a tile, by rows. What lies beyond the lattice is not set.
using WindowValues = std::array<double, window_nodes>;

/// @param value_of  (node, group) -> the values of a group of nodes from one on
template <typename ValueOf>
void read_window(const Ground& ground, std::size_t tile, WindowValues& values, const ValueOf& value_of) {
  const Lattice& lattice = ground.tiles.lattice(ground.tiles.level_of(tile));
  const NodeBlock window = ground.tiles.window(tile);
  const NodeBlock part = overlap(window, {0, 0, lattice.nx, lattice.ny});
  for (int row = part.row; row < part.end_row(); ++row) {
    const std::size_t from = lattice.index(part.column, row);
    double* const to =
        &values[static_cast<std::size_t>((row - window.row) * window_columns + part.column - window.column)];
    by_fours(0, static_cast<std::size_t>(part.columns),
             [&](std::size_t i, auto group) { group.store(to + i, value_of(from + i, group)); });
  }
}

/// The means of the cells that begin at the nodes.
void read_means_of_cells(const Ground& ground, std::size_t tile, WindowValues& means) {
  const Grid& grid = ground.grid;
  read_window(ground, tile, means, [&](std::size_t n, auto group) {
    const Lanes weight = group.load(&grid.cell_weight[n]);
    return group.load(&grid.cell_change[n]) * inverse(weight, weight > 0.0);
  });
}

/// Sums W and W e over the wet particles of every cell.
/// @param sum_runs   (set, range, tile, sums) adds up those of particles on one lattice
/// @param of_across  (set, tile) finds W e of others, which then stands in their excess
template <typename SumRuns, typename OfAcross>
void sum_in_cells(Ground& ground, const SumRuns& sum_runs, const OfAcross& of_across) {
  clear_cells(ground);
  ClockTiles& tiles = ground.clock_tiles.front();
  tiles.sums.add_to(ground.grid, cell_sums, ground.tiles, ground.workers, ground.windows,
                    [&](std::size_t n, double* window) {
                      const std::size_t tile = tiles.sums.filled()[n];
                      RowRange rows;
                      for (std::size_t s = 0; s < ground.sets.size(); ++s) {
                        const ParticleRange range = ground.sets[s].in_block(ground.block(0, tile));
                        if (!takes_pressure(ground.sets[s]) || range.begin == range.end)
                          continue;
                        sum_runs(s, range, tile, CellWindow(window));
                        rows = rows_of_window(ground, tile);
                      }
                      return rows;
                    });
  ground.workers.run(tiles.across.size(), [&](std::size_t task) {
    const AcrossTile& tile = tiles.across[task];
    if (takes_pressure(ground.sets[tile.set]))
      of_across(tile.set, tile);
  });
}

/// Adds what particles across lattices bring to their cells.
/// @param product  of a set: its W e
void complete_wet_cells(Ground& ground, std::vector<double> WaitingPressures::*product) {
  complete_cells(ground, ground.clock_tiles.front(), takes_pressure, [&](std::size_t s, std::size_t k) {
    const WaitingPressures& waiting = ground.waiting_pressures[s];
    return CellValues{waiting.cell[k], pore_volume(ground.sets[s], k), (waiting.*product)[k]};
  });
}

/// act(part, of_part) for the particles of a range, a chunk at a time, and the runs that these form.
template <typename Act>
void for_chunks(const ParticleRange& range, std::span<CellRun> runs, const Act& act) {
  auto run = runs.begin();
  for (std::size_t k = range.begin; k < range.end; k += chunk) {
    const ParticleRange part{k, std::min(k + chunk, range.end)};
    const auto first = run;
    while (run != runs.end() && run->end <= part.end)
      ++run;
    act(part, std::span(first, run));
  }
}

/// C of e = -dt theta/n. The excess pressures wait as W p_e.
/// @param flux_x,flux_y  v_s + n w
void compress(Ground& ground, double dt, const NodeField& flux_x, const NodeField& flux_y) {
  // of a set, whose excess goes to an array that begins with that of a particle
  const auto keep = [&](std::size_t s, double* excess, std::size_t begin) {
    return [&p = ground.sets[s], compression = ground.waiting_pressures[s].compression.data(), excess, begin,
            dt](std::size_t k, auto group, const Lanes& divergence) {
      group.store(&compression[k], -dt * group.load(&p.volume[k]) * divergence);
      group.store(&excess[k - begin],
                  pore_volume(p, k, group) * (group.load(&p.pore_pressure[k]) - rest_pressure(p, k, group)));
    };
  };
  sum_in_cells(
      ground,
      [&](std::size_t s, const ParticleRange& range, std::size_t tile, const CellWindow& sums) {
        const Particles& p = ground.sets[s];
        WaitingPressures& waiting = ground.waiting_pressures[s];
        for_chunks(range, waiting.runs[tile].all(), [&](const ParticleRange& part, std::span<CellRun> runs) {
          std::array<double, chunk> excess;
          for_divergences(ground, p, part, tile, flux_x, flux_y, keep(s, excess.data(), part.begin));
          std::size_t k = part.begin;
          for (CellRun& run : runs) {
            double compressed = 0.0;
            run.weight = run.product = 0.0;
            for (; k < run.end; ++k) {
              compressed += waiting.compression[k];
              run.weight += pore_volume(p, k);
              run.product += excess[k - part.begin];
            }
            sums.add(static_cast<std::size_t>(run.cell), run.weight, compressed);
          }
        });
      },
      [&](std::size_t s, const AcrossTile& tile) {
        WaitingPressures& waiting = ground.waiting_pressures[s];
        for_divergences(tile, flux_x, flux_y, keep(s, waiting.excess.data(), 0));
        const Particles& p = ground.sets[s];
        const CellFinder finder(*ground.mesh);
        for (std::size_t k = tile.weights.first(); k < tile.weights.end(); ++k)
          waiting.cell[k] = finder.at(p.x[k], p.y[k]).node;
      });
  complete_wet_cells(ground, &WaitingPressures::compression);
}

/// Adds what the runs of a set in a tile bring to nodes: their shares of the means of their cells.
template <std::size_t rows>
void add_runs(const CellRuns& runs, const WindowValues& means, double* window) {
  const Lanes* share = runs.shares();
  for (const CellRun& run : runs.all()) {
    const double mean = means[static_cast<std::size_t>(run.cell)];
    double* nodes = window + run.first;
    for (std::size_t j = 0; j < rows; ++j, nodes += window_columns)
      store(nodes, load(nodes) + mean * *share++);
  }
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
        const ParticleRange range = p.in_block(ground.block(0, tile));
        if (!takes_pressure(p) || range.begin == range.end)
          return RowRange{};
        WindowValues means;
        read_means_of_cells(ground, tile, means);
        for_boxes(p, [&]<typename Boxes>() {
          add_runs<Boxes::rows>(waiting_of(ground, p).runs[tile], means,
                                window + fields.front().first * window_nodes);
        });
        return rows_of_window(ground, tile);
      },
      [&](AcrossTile& tile) {
        const Particles& p = ground.sets[tile.set];
        add_across_tile(tile, fields.front(), [&](std::size_t k, const FourWeights& w, const auto& add) {
          if (takes_pressure(p))
            add(fields.front().first,
                pore_volume(p, k) * mean_of_cell(grid, waiting_of(ground, p).cell[k]) * w.s);
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

/// Adds up in cells what runs have of the excess, and K_f times what they read from the nodes.
template <std::size_t rows>
void sum_excess(const CellRuns& runs, const WindowValues& means, double bulk_modulus,
                const CellWindow& sums) {
  const Lanes* share = runs.shares();
  for (const CellRun& run : runs.all()) {
    const double* nodes = means.data() + run.first;
    Lanes read = *share++ * load(nodes);
    for (std::size_t j = 1; j < rows; ++j)
      read += *share++ * load(nodes += window_columns);
    sums.add(static_cast<std::size_t>(run.cell), run.weight, run.product + bulk_modulus * sum(read));
  }
}

/// C of the excess pressures, which take up K_f times what particles read from the nodes.
void average_again(Ground& ground) {
  const NodeField& mean = ground.grid.compression;
  sum_in_cells(
      ground,
      [&](std::size_t s, const ParticleRange&, std::size_t tile, const CellWindow& sums) {
        const Particles& p = ground.sets[s];
        WindowValues means;
        read_window(ground, tile, means, [&](std::size_t n, auto group) { return group.load(&mean[n]); });
        for_boxes(p, [&]<typename Boxes>() {
          sum_excess<Boxes::rows>(ground.waiting_pressures[s].runs[tile], means, p.water->fluid.bulk_modulus,
                                  sums);
        });
      },
      [&](std::size_t s, const AcrossTile& tile) {
        const Particles& p = ground.sets[s];
        double* const excess = ground.waiting_pressures[s].excess.data();
        for_numbers(tile, mean, [&](std::size_t k, double change) {
          excess[k] += pore_volume(p, k) * p.water->fluid.bulk_modulus * change;
        });
      });
  complete_wet_cells(ground, &WaitingPressures::excess);
}

/// Gives a range its pressures; returns the work by the trapezoidal rule.
/// @param excess  of the range
Lanes take_pressures(Particles& p, const ParticleRange& range, const double* compression,
                     const double* excess) {
  const Lanes least = all(p.water->fluid.cavitation_pressure);
  Lanes work{};
  by_fours(range.begin, range.end, [&](std::size_t k, auto group) {
    const Lanes before = group.load(&p.pore_pressure[k]);
    const Lanes at_rest = rest_pressure(p, k, group);
    const Lanes after = at_rest + group.load(&excess[k - range.begin]);
    group.store(&p.pore_pressure[k], after);
    work += (0.5 * (larger(before, least) + larger(after, least)) - at_rest) * group.load(&compression[k]);
  });
  return work;
}

/// Gives the particles of a block the pressures of their cells; returns the work.
double take_pressures(Ground& ground, Particles& p, std::size_t block) {
  WaitingPressures& waiting = waiting_of(ground, p);
  const ParticleRange range = p.in_block(block);
  if (block >= ground.block_count()) {
    for (std::size_t k = range.begin; k < range.end; ++k)
      waiting.excess[k] = mean_of_cell(ground.grid, waiting.cell[k]);
    return sum(take_pressures(p, range, waiting.compression.data(), &waiting.excess[range.begin]));
  }
  WindowValues means;
  read_means_of_cells(ground, block, means); // on the only clock a block is a tile
  Lanes work{};
  for_chunks(range, waiting.runs[block].all(), [&](const ParticleRange& part, std::span<const CellRun> runs) {
    std::array<double, chunk> excess;
    std::size_t k = part.begin;
    for (const CellRun& run : runs)
      for (const double mean = means[static_cast<std::size_t>(run.cell)]; k < run.end; ++k)
        excess[k - part.begin] = mean;
    work += take_pressures(p, part, waiting.compression.data(), excess.data());
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
      if (const ParticleRange range = p.in_block(block); takes_pressure(p) && range.begin < range.end)
        works[block][0] += take_pressures(ground, p, block);
  });
  return sums_of(std::span<const std::array<double, 1>>(works));
}

} // namespace

WaitingPressures& waiting_of(Ground& ground, const Particles& p) {
  return ground.waiting_pressures[static_cast<std::size_t>(&p - ground.sets.data())];
}

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
