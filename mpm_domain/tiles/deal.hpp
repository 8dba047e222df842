#pragma once

// Assignment of tiles to ranks. Tiles with particles are put in the order of a Hilbert curve (Hilbert 1891,
// Math. Ann. 38, 459-460) over the lattice, which never leaves a neighbourhood before it has seen it all, and
// the curve is cut into pieces of nearly the same load, the time that a step takes for their particles. So a
// rank's tiles lie together, and their common rim is short. A tile without particles belongs to the owner of
// a neighbour with some: it must be ready for those that come before the next sort.
//
// Some tiles stay together. The first rank holds all that structures touch: what passes between structures
// and soil is worked out there alone, from the tiles of all particles and nodes that take part. It also holds
// all tiles next to cells of other sizes, so that nothing that joins lattices concerns others. These tiles go
// to the first rank whatever they hold, and the others make up for it. Tiles whose nodes are images of each
// other are dealt as one, where the first of them lies on the curve.

#include "mpm_domain/tiles/tile_map.hpp"
#include "mpm_domain/tiles/tile_times.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator;

struct Deal {
  static constexpr int nobody = -1;

  std::vector<int> owner;         ///< by tile; nobody: no particle comes near it before the next sort
  std::vector<std::int64_t> load; ///< by tile, of the particles of all ranks that are on its lattice alone
};

/// Load of the fullest rank over the mean, beyond which tiles are dealt anew.
inline constexpr double most_uneven = 1.15;

/// Tiles that stay together. Each tile is alone or in one of these lists, whose tiles rise.
struct Together {
  std::vector<std::size_t> of_first;
  std::int64_t besides = 0; ///< load of the particles of the first rank that are not on one lattice alone
  std::vector<std::vector<std::size_t>> groups; ///< each of one rank
};

/// Deals the tiles of a map among ranks.
Deal deal_out(const TileMap& tiles, std::vector<std::int64_t> load, int ranks, const Together& together = {});

/// The deal for another load: the present one, or another if that has become uneven, or if particles have
/// come to a tile that nobody owns, or if tiles have been parted that are to stay together.
Deal follow(const Deal& present, const TileMap& tiles, std::vector<std::int64_t> load, int ranks,
            const Together& together = {});

/// The present deal of these tiles, or another one whose fullest rank has less by 3 % of the mean.
Deal improved(const Deal& present, const TileMap& tiles, std::vector<std::int64_t> load, int ranks,
              const Together& together = {});

/// Load of the fullest rank over the mean, or over what the first rank has to take where this is more.
double unevenness(const Deal& deal, int ranks, const Together& together = {});

/// A rank's share of a domain.
struct RankShare {
  Communicator* ranks; ///< outlives the domain
  Deal deal;
  std::vector<std::int64_t> updates = {}; ///< by tile, of the particles of all ranks in a step of clock 0
  TileTimes times = {};                   ///< of this rank
  int looks = 0;                          ///< how often is_time_to_look() has said so
  std::vector<mesh::Rectangle> structures = {}; ///< boxes around all that these may touch until the next sort

  int owner(std::size_t tile) const { return deal.owner[tile]; }
  bool is_mine(std::size_t tile) const;
  /// Whether a look at what tiles have cost is due: after 20 steps, then 40, 80, ..., on all ranks at once.
  bool is_time_to_look();
  /// Whether structures may touch a point (m) until the next sort.
  bool structures_reach(const Vector& point) const;
};

} // namespace tremolo::mpm_domain
