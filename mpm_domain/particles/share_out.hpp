#pragma once

// Particles of a domain that ranks share. Each rank has those of its own tiles, in the order that they have
// in the whole domain: tile by tile. At a sort, particles go to the rank that owns their new tile, where they
// are put back into the order of their old tiles before they are sorted. Sorting keeps the order of those that
// share a cell, so all ranks together hold the particles as one rank would.

#include "mpm_domain/domain.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// What of a domain ranks cannot share yet, as a subject of a sentence; nothing if they can share it.
std::optional<std::string> not_for_ranks(const Spec& spec);

/// Leaves a whole domain, which is the same on all ranks, with this rank's share of it.
/// @param ranks  outlives the domain
/// @throws std::invalid_argument for what not_for_ranks() names
void share_out(Domain& domain, Communicator& ranks);

/// Gives particles that have come to tiles of other ranks to these; deals the tiles anew where they are
/// uneven. A part of the sort.
void move_between_ranks(Domain& domain);

/// The sets of the whole domain, on rank 0; on others nothing. They are ordered as at the last sort. All
/// ranks call it.
std::vector<Particles> gather_sets(const Domain& domain);

} // namespace tremolo::mpm_domain
