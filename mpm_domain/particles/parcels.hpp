#pragma once

// Particles on their way between ranks, as numbers: of each its block, its id, its fields, its state, and
// what goes with it besides.
//
// The particles of a block come from one rank, in their order. So those of all ranks are in order again when
// they stand block by block.

#include "mpm_domain/particles/particles.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The numbers of particles of a set, one behind the other.
using Parcel = std::vector<double>;

/// Calls act(k, block) for the particles [first, end) of a set. Quarters of particles that have been cut
/// since the last sort stand in a block behind all others.
template <typename Act>
void with_blocks(const Particles& set, std::size_t first, std::size_t end, const Act& act) {
  std::size_t block = 0;
  for (std::size_t k = first; k < end; ++k) {
    while (block + 1 < set.block_start.size() && k >= set.block_start[block + 1])
      ++block;
    act(k, block);
  }
}

/// Adds a particle to a parcel; what goes with it besides is to be added next.
void pack(const Particles& set, std::size_t k, std::size_t block, Parcel& parcel);

/// Leaves a set with its particles that stay and those that have come, in order.
/// @param blocks   in which they stand then
/// @param stays    by particle; empty: all stay
/// @param arrived  parcels of this set
/// @param more     how many numbers go with a particle besides
/// @returns these numbers of those that have come, particle after particle
std::vector<double> rearrange(Particles& set, std::size_t blocks, const std::vector<bool>& stays,
                              std::span<const Parcel> arrived, std::size_t more = 0);

} // namespace tremolo::mpm_domain
