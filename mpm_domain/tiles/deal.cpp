#include "mpm_domain/tiles/deal.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// The place of a cell on the Hilbert curve through a square of `size` cells a side, a power of two. From
/// quarter to quarter, the curve within is turned so that its ends meet.
std::uint64_t hilbert_place(std::uint32_t size, std::uint32_t x, std::uint32_t y) {
  std::uint64_t place = 0;
  for (std::uint32_t half = size / 2; half > 0; half /= 2) {
    const bool right = (x & half) != 0;
    const bool up = (y & half) != 0;
    place += std::uint64_t{half} * half * ((right ? 3U : 0U) ^ (up ? 1U : 0U));
    if (!up) {
      if (right) {
        x = size - 1 - x;
        y = size - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return place;
}

std::vector<std::size_t> filled_along_curve(const TileMap& tiles,
                                            const std::vector<std::int64_t>& particles) {
  struct Filled {
    std::uint64_t place;
    std::size_t tile;
  };
  const auto longest = static_cast<std::uint32_t>(
      std::max(tiles.lattice(0).nx / tile_columns, tiles.lattice(0).ny / tile_rows));
  const std::uint32_t size = std::bit_ceil(longest + 1);
  std::vector<Filled> filled;
  for (std::size_t tile = 0; tile < particles.size(); ++tile)
    if (particles[tile] > 0) {
      const NodeBlock own = tiles.owned(tile);
      filled.push_back({hilbert_place(size, static_cast<std::uint32_t>(own.column / tile_columns),
                                      static_cast<std::uint32_t>(own.row / tile_rows)),
                        tile});
    }
  std::ranges::sort(filled, {}, &Filled::place);
  std::vector<std::size_t> order;
  for (const Filled& one : filled)
    order.push_back(one.tile);
  return order;
}

/// The neighbour with particles that is to own an empty tile: one with a side in common, if there is any, so
/// that rims do not grow at the surface.
std::size_t neighbour_with_particles(const Deal& deal, const TileMap& tiles, std::size_t tile) {
  const NodeBlock own = tiles.owned(tile);
  std::size_t found = tile;
  for (const std::size_t other : tiles.around(tile)) {
    if (deal.particles[other] == 0)
      continue;
    const NodeBlock of_other = tiles.owned(other);
    if (of_other.column == own.column || of_other.row == own.row)
      return other;
    if (found == tile)
      found = other;
  }
  return found;
}

/// Gives tiles without particles to the owner of a neighbour with some.
void adopt_empty(Deal& deal, const TileMap& tiles) {
  for (std::size_t tile = 0; tile < deal.owner.size(); ++tile) {
    if (deal.particles[tile] > 0)
      continue;
    const std::size_t neighbour = neighbour_with_particles(deal, tiles, tile);
    deal.owner[tile] = neighbour == tile ? Deal::nobody : deal.owner[neighbour];
  }
}

} // namespace

Deal deal_out(const TileMap& tiles, std::vector<std::int64_t> particles, int ranks) {
  Deal deal{std::vector<int>(particles.size(), Deal::nobody), std::move(particles)};
  const std::int64_t total = std::accumulate(deal.particles.begin(), deal.particles.end(), std::int64_t{0});
  std::int64_t before = 0;
  for (const std::size_t tile : filled_along_curve(tiles, deal.particles)) {
    // The rank in whose piece of the curve the middle of the tile's particles lies.
    deal.owner[tile] = static_cast<int>((2 * before + deal.particles[tile]) * ranks / (2 * total));
    before += deal.particles[tile];
  }
  adopt_empty(deal, tiles);
  return deal;
}

Deal follow(const Deal& present, const TileMap& tiles, std::vector<std::int64_t> particles, int ranks) {
  if (present.owner.size() != particles.size())
    return deal_out(tiles, std::move(particles), ranks);
  Deal next{present.owner, std::move(particles)};
  for (std::size_t tile = 0; tile < next.owner.size(); ++tile)
    if (next.particles[tile] > 0 && next.owner[tile] == Deal::nobody)
      return deal_out(tiles, std::move(next.particles), ranks);
  if (unevenness(next, ranks) > most_uneven)
    return deal_out(tiles, std::move(next.particles), ranks);
  adopt_empty(next, tiles);
  return next;
}

double unevenness(const Deal& deal, int ranks) {
  std::vector<std::int64_t> load(static_cast<std::size_t>(ranks), 0);
  std::int64_t total = 0;
  for (std::size_t tile = 0; tile < deal.owner.size(); ++tile)
    if (deal.particles[tile] > 0) {
      load[static_cast<std::size_t>(deal.owner[tile])] += deal.particles[tile];
      total += deal.particles[tile];
    }
  return static_cast<double>(ranks) * static_cast<double>(std::ranges::max(load)) /
         static_cast<double>(total);
}

bool RankShare::is_mine(std::size_t tile) const {
  return deal.owner[tile] == ranks->rank();
}

} // namespace tremolo::mpm_domain
