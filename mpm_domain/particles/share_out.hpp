#pragma once

// Particles of a domain that ranks share. Each rank has those of its own tiles, in the order that they have
// in the whole domain: tile by tile. At a sort, particles go to the rank that owns their new tile, where they
// are put back into the order of their old tiles before they are sorted. Sorting keeps the order of those
// that share a cell, so all ranks together hold the particles as one rank would.

#include "mpm_domain/ground.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace tremolo::mpm_domain {

/// Deals the tiles among ranks, for the particles of all in the blocks that `block_start` of the sets says.
/// @param ranks       outlives the ground
/// @param structures  boxes around all that these may touch until the next sort
void deal_out_blocks(Ground& ground, Communicator& ranks, std::vector<mesh::Rectangle> structures);

/// Gives particles that have come to tiles of other ranks to these; deals the tiles anew where they are
/// uneven, or where structures have come to others. A part of the sort.
void move_between_ranks(Ground& ground);

/// Between two sorts: deals the tiles anew where what they have cost is uneven, and gives particles to the
/// ranks of their tiles. What they may touch must be found next: find_reach(). All ranks call it.
/// @returns whether they are; the grid's fields are zero then
bool deal_anew(Ground& ground);

/// Particles that ranks have given to rank 0; on others nothing.
struct GatheredSets {
  std::vector<Particles> sets;              ///< ordered as at the last sort
  std::vector<std::vector<double>> numbers; ///< by set: what was added, particle after particle
};

/// Whether a particle is wanted.
using Wanted = std::function<bool(std::size_t set, std::size_t k)>;
/// Adds numbers that go with a particle, as many for each.
using AddNumbers = std::function<void(std::size_t set, std::size_t k, std::vector<double>& to)>;

/// Gives the particles of the whole domain that are wanted to rank 0. All ranks call it.
/// @param more  how many numbers `add_numbers` adds
GatheredSets gather_sets(const Ground& ground, const Wanted& wanted, std::size_t more,
                         const AddNumbers& add_numbers);

} // namespace tremolo::mpm_domain
