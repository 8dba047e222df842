#pragma once

// Loops over particles that read from the grid, tile by tile.

#include "mpm_domain/transfer/samples.hpp"

namespace tremolo::mpm_domain {

/// act(k, group, reader) for the particles of a set in a tile that touch its lattice alone.
template <typename Act>
void for_readers(const Ground& ground, const Particles& p, const ParticleRange& range, std::size_t tile,
                 const Act& act) {
  const Lattice& lattice = ground.tiles.lattice(ground.tiles.level_of(tile));
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  for_boxes(p, [&]<typename Boxes>() {
    const Boxes boxes(p, lattice, x_axis);
    by_fours(
        range.begin, range.end, [&](std::size_t k, auto group) __attribute__((always_inline)) {
          const auto& own = boxes.of(k, group);
          const Stencils at(group.load(&p.x[k]), group.load(&p.y[k]), x_axis, y_axis, own);
          act(k, group, Reader<Boxes::rows>(at, group.count, lattice, x_axis, y_axis, own));
        });
  });
}

/// act(k, group, divergence) of a field of vectors.
template <typename Act>
void for_divergences(const Ground& ground, const Particles& p, const ParticleRange& range, std::size_t tile,
                     const NodeField& field_x, const NodeField& field_y, const Act& act) {
  for_readers(ground, p, range, tile, [&](std::size_t k, auto group, const auto& reader) {
    act(k, group, reader.divergence(field_x, field_y));
  });
}

template <typename Act>
void for_divergences(const AcrossTile& tile, const NodeField& field_x, const NodeField& field_y,
                     const Act& act) {
  for (std::size_t k = tile.weights.first(); k < tile.weights.end(); ++k) {
    Lanes divergence{};
    for (const FourWeights& w : tile.weights.of(k)) {
      const auto& n = w.node;
      divergence += w.gx * Lanes{field_x[n[0]], field_x[n[1]], field_x[n[2]], field_x[n[3]]} +
                    w.gy * Lanes{field_y[n[0]], field_y[n[1]], field_y[n[2]], field_y[n[3]]};
    }
    act(k, FewerThanFour(1), all(sum(divergence)));
  }
}

/// act(k, sum S q) of a field of numbers.
template <typename Act>
void for_numbers(const AcrossTile& tile, const NodeField& field, const Act& act) {
  for (std::size_t k = tile.weights.first(); k < tile.weights.end(); ++k) {
    Lanes number{};
    for (const FourWeights& w : tile.weights.of(k)) {
      const auto& n = w.node;
      number += w.s * Lanes{field[n[0]], field[n[1]], field[n[2]], field[n[3]]};
    }
    act(k, sum(number));
  }
}

/// Passes over all particles of a clock, tiles side by side: in_tile(set, range, tile) for those of a set in
/// a tile that touch one lattice, across(set, tile) for those that touch several.
template <typename InTile, typename Across>
void for_tiles(Ground& ground, int clock, const InTile& in_tile, const Across& across) {
  ClockTiles& tiles = ground.clock_tiles[static_cast<std::size_t>(clock)];
  const std::span<const std::size_t> filled = tiles.sums.filled();
  ground.workers.run(filled.size() + tiles.across.size(), [&](std::size_t task) {
    if (task >= filled.size()) {
      AcrossTile& tile = tiles.across[task - filled.size()];
      across(ground.sets[tile.set], tile);
      return;
    }
    for (Particles& p : ground.sets)
      if (const ParticleRange range = p.in_block(ground.block(clock, filled[task])); range.begin < range.end)
        in_tile(p, range, filled[task]);
  });
}

} // namespace tremolo::mpm_domain
