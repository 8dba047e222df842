#pragma once

#include "mpm_domain/ground.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// Adds the sums of particles across lattices to the nodes.
void add_across(Ground& ground, std::span<const AcrossTile> tiles, std::span<const SumRange> fields);

/// Adds up what the particles of a clock bring to the given fields of the nodes, tile by tile.
/// @param fill    (set, tile, window) adds those of a set in a tile to the tile's window and returns the rows
///                that they touch
/// @param across  (tile) adds up those of a tile's particles that touch several lattices
template <typename FillSet, typename Across>
void add_sums(Ground& ground, int clock, std::span<const SumRange> fields, const FillSet& fill,
              const Across& across) {
  ClockTiles& tiles = ground.clock_tiles[static_cast<std::size_t>(clock)];
  tiles.sums.add_to(ground.grid, fields, ground.tiles, ground.workers, ground.windows,
                    [&](std::size_t n, double* window) {
                      RowRange touched;
                      for (Particles& p : ground.sets)
                        touched.add(fill(p, tiles.sums.filled()[n], window));
                      return touched;
                    });
  if (tiles.across.empty())
    return;
  ground.workers.run(tiles.across.size(), [&](std::size_t task) { across(tiles.across[task]); });
  add_across(ground, tiles.across, fields);
}

} // namespace tremolo::mpm_domain
