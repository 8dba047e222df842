#pragma once

// Which rank owns which tile. Tiles with particles are put in the order of a Hilbert curve (Hilbert 1891,
// Math. Ann. 38, 459-460) over the lattice, which never leaves a neighbourhood before it has seen it all, and
// the curve is cut into pieces of nearly the same number of particles. So a rank's tiles lie together, and
// their common rim is short. A tile without particles belongs to the owner of a neighbour with some: it must
// be ready for those that come before the next sort.

#include "mpm_domain/tiles/tile_map.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator;

struct Deal {
  static constexpr int nobody = -1;

  std::vector<int> owner;              ///< by tile; nobody: no particle comes near it before the next sort
  std::vector<std::int64_t> particles; ///< by tile, those of all ranks
};

/// Particles of the fullest rank over their mean, beyond which tiles are dealt anew.
inline constexpr double most_uneven = 1.15;

/// Deals the tiles of a map with one lattice among ranks.
Deal deal_out(const TileMap& tiles, std::vector<std::int64_t> particles, int ranks);

/// The deal for other numbers of particles: the present one, or another if that has become uneven, or if
/// particles have come to a tile that nobody owns.
Deal follow(const Deal& present, const TileMap& tiles, std::vector<std::int64_t> particles, int ranks);

/// Particles of the fullest rank over their mean.
double unevenness(const Deal& deal, int ranks);

/// A rank's share of a domain.
struct RankShare {
  Communicator* ranks; ///< outlives the domain
  Deal deal;

  int owner(std::size_t tile) const { return deal.owner[tile]; }
  bool is_mine(std::size_t tile) const;
};

} // namespace tremolo::mpm_domain
