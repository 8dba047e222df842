#include "mpm_domain/tiles/deal.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

std::int64_t load_of(const std::vector<std::size_t>& tiles, const std::vector<std::int64_t>& load) {
  std::int64_t sum = 0;
  for (const std::size_t tile : tiles)
    sum += load[tile];
  return sum;
}

/// The place of a cell on the Hilbert curve through a square of `size` cells a side, a power of two. From
/// quarter to quarter, the curve within is turned so that its ends meet.
std::uint64_t hilbert_place(std::uint32_t size, std::uint32_t x, std::uint32_t y) {
  std::uint64_t position = 0;
  for (std::uint32_t half = size / 2; half > 0; half /= 2) {
    const bool right = (x & half) != 0;
    const bool up = (y & half) != 0;
    position += std::uint64_t{half} * half * ((right ? 3U : 0U) ^ (up ? 1U : 0U));
    if (!up) {
      if (right) {
        x = size - 1 - x;
        y = size - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return position;
}

/// A tile or a group with particles, at the place of the first of its tiles on the curve.
struct Piece {
  std::uint64_t position;
  std::vector<std::size_t> tiles;
  std::int64_t load;
};

/// All but those that are the first rank's anyway, along the curve.
std::vector<Piece> pieces_along_curve(const TileMap& tiles, const std::vector<std::int64_t>& load,
                                      const Together& together) {
  // The curve goes through tiles of the finest lattice, and meets others at their first corner.
  const Lattice& root = tiles.lattice(0);
  double h = root.h;
  for (int level = 1; level < tiles.lattice_count(); ++level)
    h = std::min(h, tiles.lattice(level).h);
  const auto in_tiles = [&](double way, int nodes) {
    return static_cast<std::uint32_t>(std::max(0.0, std::floor((way + 0.5 * h) / (h * nodes))));
  };
  const std::uint32_t size = std::bit_ceil(
      1 + std::max(in_tiles(root.nx * root.h, tile_columns), in_tiles(root.ny * root.h, tile_rows)));
  const auto position_of = [&](std::size_t tile) {
    const NodeBlock own = tiles.owned(tile);
    const Lattice& of = tiles.lattice(tiles.level_of(tile));
    return hilbert_place(size, in_tiles(of.x0 + own.column * of.h - root.x0, tile_columns),
                         in_tiles(of.y0 + own.row * of.h - root.y0, tile_rows));
  };
  std::vector<bool> is_taken(load.size(), false);
  for (const std::size_t tile : together.of_first)
    is_taken[tile] = true;
  std::vector<Piece> pieces;
  for (const std::vector<std::size_t>& group : together.groups) {
    Piece piece{position_of(group.front()), group, load_of(group, load)};
    for (const std::size_t tile : group)
      is_taken[tile] = true;
    if (piece.load > 0)
      pieces.push_back(std::move(piece));
  }
  for (std::size_t tile = 0; tile < load.size(); ++tile)
    if (load[tile] > 0 && !is_taken[tile])
      pieces.push_back({position_of(tile), {tile}, load[tile]});
  std::ranges::sort(pieces, {}, &Piece::position);
  return pieces;
}

/// The neighbour with particles that is to own an empty tile: one with a side in common, if there is any, so
/// that rims do not grow at the surface.
std::size_t neighbour_with_particles(const Deal& deal, const TileMap& tiles, std::size_t tile) {
  const NodeBlock own = tiles.owned(tile);
  std::size_t found = tile;
  for (const std::size_t other : tiles.around(tile)) {
    if (deal.load[other] == 0)
      continue;
    const NodeBlock of_other = tiles.owned(other);
    if (of_other.column == own.column || of_other.row == own.row)
      return other;
    if (found == tile)
      found = other;
  }
  return found;
}

/// Gives tiles without particles to the owner of a neighbour with some, and those of a group to one owner.
void adopt_empty(Deal& deal, const TileMap& tiles, const Together& together) {
  for (std::size_t tile = 0; tile < deal.owner.size(); ++tile) {
    if (deal.load[tile] > 0 || std::ranges::binary_search(together.of_first, tile))
      continue;
    const std::size_t neighbour = neighbour_with_particles(deal, tiles, tile);
    deal.owner[tile] = neighbour == tile ? Deal::nobody : deal.owner[neighbour];
  }
  for (const std::vector<std::size_t>& group : together.groups) {
    int owner = Deal::nobody;
    for (const std::size_t tile : group)
      if (owner == Deal::nobody || deal.load[tile] > 0)
        owner = deal.owner[tile];
    for (const std::size_t tile : group)
      deal.owner[tile] = owner;
  }
}

/// Whether a deal has parted what is to stay together, or leaves particles to nobody.
bool is_lost(const Deal& deal, const Together& together) {
  for (std::size_t tile = 0; tile < deal.owner.size(); ++tile)
    if (deal.load[tile] > 0 && deal.owner[tile] == Deal::nobody)
      return true;
  const auto is_parted = [&](const std::vector<std::size_t>& group) {
    int owner = Deal::nobody;
    for (const std::size_t tile : group) {
      if (deal.load[tile] == 0)
        continue;
      if (owner != Deal::nobody && deal.owner[tile] != owner)
        return true;
      owner = deal.owner[tile];
    }
    return false;
  };
  return std::ranges::any_of(together.of_first, [&](std::size_t tile) { return deal.owner[tile] != 0; }) ||
         std::ranges::any_of(together.groups, is_parted);
}

} // namespace

Deal deal_out(const TileMap& tiles, std::vector<std::int64_t> load, int ranks, const Together& together) {
  Deal deal{std::vector<int>(load.size(), Deal::nobody), std::move(load)};
  std::int64_t total = std::accumulate(deal.load.begin(), deal.load.end(), std::int64_t{0});
  std::int64_t before = load_of(together.of_first, deal.load) + together.besides;
  total += together.besides;
  for (const std::size_t tile : together.of_first)
    deal.owner[tile] = 0;
  // If these are a full share, all other tiles go to the other ranks.
  const int full = ranks > 1 && before > 0 && before * ranks >= total ? 1 : 0;
  if (full == 1)
    total -= std::exchange(before, 0);
  for (const Piece& piece : pieces_along_curve(tiles, deal.load, together)) {
    // The rank in whose piece of the curve the middle of this load lies.
    for (const std::size_t tile : piece.tiles)
      deal.owner[tile] = full + static_cast<int>((2 * before + piece.load) * (ranks - full) / (2 * total));
    before += piece.load;
  }
  adopt_empty(deal, tiles, together);
  return deal;
}

Deal follow(const Deal& present, const TileMap& tiles, std::vector<std::int64_t> load, int ranks,
            const Together& together) {
  if (present.owner.size() != load.size())
    return deal_out(tiles, std::move(load), ranks, together);
  Deal next{present.owner, std::move(load)};
  if (is_lost(next, together) || unevenness(next, ranks, together) > most_uneven)
    return deal_out(tiles, std::move(next.load), ranks, together);
  adopt_empty(next, tiles, together);
  return next;
}

Deal improved(const Deal& present, const TileMap& tiles, std::vector<std::int64_t> load, int ranks,
              const Together& together) {
  constexpr double worth_moving = 0.03;
  Deal now{present.owner, load};
  Deal next = deal_out(tiles, std::move(load), ranks, together);
  const bool is_better = unevenness(next, ranks, together) + worth_moving < unevenness(now, ranks, together);
  return is_better ? next : now;
}

double unevenness(const Deal& deal, int ranks, const Together& together) {
  std::vector<std::int64_t> of_ranks(static_cast<std::size_t>(ranks), 0);
  of_ranks.front() = together.besides;
  std::int64_t total = together.besides;
  for (std::size_t tile = 0; tile < deal.owner.size(); ++tile)
    if (deal.load[tile] > 0) {
      of_ranks[static_cast<std::size_t>(deal.owner[tile])] += deal.load[tile];
      total += deal.load[tile];
    }
  const double mean = static_cast<double>(total) / static_cast<double>(ranks);
  const double least =
      std::max(mean, static_cast<double>(load_of(together.of_first, deal.load) + together.besides));
  return static_cast<double>(std::ranges::max(of_ranks)) / least;
}

bool RankShare::is_mine(std::size_t tile) const {
  return deal.owner[tile] == ranks->rank();
}

bool RankShare::is_time_to_look() {
  constexpr std::int64_t first = 20;
  constexpr int most_doublings = 20;
  const bool is_time = times.steps() == first << std::min(looks, most_doublings);
  looks += is_time ? 1 : 0;
  return is_time;
}

bool RankShare::structures_reach(const Vector& point) const {
  return std::ranges::any_of(structures, [&](const mesh::Rectangle& box) {
    return point.x > box.x_min && point.x < box.x_max && point.y > box.y_min && point.y < box.y_max;
  });
}

} // namespace tremolo::mpm_domain
