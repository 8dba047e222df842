#include "mpm_domain/strain/cell_dilatation.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// Particles whose law is one task.
struct StrainPart {
  std::size_t tile;
  std::size_t set;
  std::size_t begin;
  std::size_t count;
};

/// The parts of the particles of a clock, the same for any number of threads and ranks. A law may cost many
/// times as much where it yields, so that tiles would keep some threads waiting for others.
std::vector<StrainPart> parts_of(const Ground& ground, int clock) {
  const ClockTiles& tiles = ground.clock_tiles[static_cast<std::size_t>(clock)];
  std::vector<StrainPart> parts;
  const auto cut = [&](std::size_t tile, std::size_t s, const ParticleRange& range) {
    for (std::size_t first = range.begin; first < range.end; first += strain_chunk_size)
      parts.push_back({tile, s, first, std::min(strain_chunk_size, range.end - first)});
  };
  for (std::size_t s = 0; s < ground.sets.size(); ++s) {
    if (!ground.sets[s].traits.cell_dilatation)
      continue;
    for (const std::size_t tile : tiles.sums.filled())
      cut(tile, s, ground.sets[s].in_block(ground.block(clock, tile)));
    for (const AcrossTile& tile : tiles.across)
      if (tile.set == s)
        cut(tile.tile, s, {tile.weights.first(), tile.weights.end()});
  }
  return parts;
}

GatherSums strain_part(Ground& ground, const StrainPart& part, double dt) {
  const TileTimer timer(ground.tile_times(), part.tile);
  const WaitingStrains& strains = ground.waiting_strains[part.set];
  LaneSums sums;
  Increments moved{}; // lanes beyond the last particle are read, and count nothing
  Increments seen{};
  for (std::size_t c = 0; c < part.count; ++c) {
    const std::size_t k = part.begin + c;
    const double mean = mean_of_cell(ground.grid, strains.cell[k]);
    const double half_excess = 0.5 * (mean - (strains.exx[k] + strains.eyy[k]));
    moved.exx[c] = strains.exx[k];
    moved.eyy[c] = strains.eyy[k];
    seen.exx[c] = strains.exx[k] + half_excess;
    seen.eyy[c] = strains.eyy[k] + half_excess;
    moved.gxy[c] = seen.gxy[c] = strains.gxy[k];
    seen.wxy[c] = strains.wxy[k];
    seen.plastic[c] = 0.0;
  }
  strain_chunk(ground.sets[part.set], part.begin, part.count, seen, moved, dt, sums);
  return sums.collected();
}

} // namespace

WaitingRange::WaitingRange(WaitingStrains& strains, const TileMap& tiles, std::size_t tile, double* window)
    : strains_(strains), finder_(tiles, tile), window_(window) {}

WaitingRange::WaitingRange(WaitingStrains& strains, const GradedMesh& mesh)
    : strains_(strains), finder_(mesh) {}

void WaitingRange::find_cells(const Particles& p, std::size_t first, std::size_t count) {
  for (std::size_t c = 0; c < count; ++c) {
    const CellFinder::Cell cell = finder_.at(p.x[first + c], p.y[first + c]);
    strains_.cell[first + c] = cell.node;
    in_window_[c] = cell.in_window;
  }
}

void WaitingRange::hold(const Particles& p, std::size_t first, std::size_t count,
                        const Increments& increments) {
  const auto copy = [&](const ChunkField& from, std::vector<double>& to) {
    std::copy_n(from.begin(), count, to.begin() + static_cast<std::ptrdiff_t>(first));
  };
  copy(increments.exx, strains_.exx);
  copy(increments.eyy, strains_.eyy);
  copy(increments.gxy, strains_.gxy);
  copy(increments.wxy, strains_.wxy);
  if (window_ == nullptr)
    return;
  const CellWindow sums(window_);
  for (std::size_t c = 0; c < count; ++c) {
    const double volume = p.volume[first + c];
    sums.add(in_window_[c], volume, volume * (increments.exx[c] + increments.eyy[c]));
  }
}

bool some_wait(const Ground& ground) {
  return std::ranges::any_of(ground.sets, [](const Particles& p) { return p.traits.cell_dilatation; });
}

void clear_strains(Ground& ground) {
  clear_cells(ground);
  for (std::size_t s = 0; s < ground.sets.size(); ++s)
    if (ground.sets[s].traits.cell_dilatation)
      ground.waiting_strains[s].resize(ground.sets[s].size());
}

std::vector<GatherSums> strain_by_cells(Ground& ground, int clock, double dt) {
  const ClockTiles& tiles = ground.clock_tiles[static_cast<std::size_t>(clock)];
  complete_cells(
      ground, tiles, [](const Particles& p) { return p.traits.cell_dilatation; },
      [&](std::size_t s, std::size_t k) {
        const WaitingStrains& strains = ground.waiting_strains[s];
        const double volume = ground.sets[s].volume[k];
        return CellValues{strains.cell[k], volume, volume * (strains.exx[k] + strains.eyy[k])};
      });
  const std::vector<StrainPart> parts = parts_of(ground, clock);
  std::vector<GatherSums> sums(parts.size());
  ground.workers.run(parts.size(), [&](std::size_t n) { sums[n] = strain_part(ground, parts[n], dt); });
  return sums;
}

} // namespace tremolo::mpm_domain
