#pragma once

// Ranks fill a domain together, so that none of them ever has all particles. Each lays a part of the rows of
// lattice points, or of the leaves of a graded mesh, and particles get the numbers that one process would
// give them: those of a set on lower ranks come first. Elastic bodies, which are little beside the ground,
// are filled by all, until structures have been built in them; then the first rank alone has them.

#include "mpm_domain/head/head.hpp"
#include "mpm_domain/particles/particles.hpp"

#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator;

/// The part of this rank, as fill() lays it; those of each rank are a block of a set.
/// @throws std::invalid_argument as fill() does, and if a set has more particles than there are numbers
std::vector<Particles> fill_together(const Spec& spec, const std::optional<Head>& head,
                                     const mesh::Quadtree* tree, Communicator& ranks);

/// Leaves the first rank with sets that each of them has filled, and the others with empty ones of that kind.
void leave_to_first(std::span<Particles> sets, const Communicator& ranks);

} // namespace tremolo::mpm_domain
