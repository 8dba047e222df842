#pragma once

// Ranks fill a domain together, so that none of them ever has all particles. Each lays a part of the rows of
// lattice points, or of the leaves of a graded mesh, and particles get the numbers that one process would
// give them: those of a set on lower ranks come first.

#include "mpm_domain/head/head.hpp"
#include "mpm_domain/particles/particles.hpp"

#include <optional>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator;

/// Whether ranks may: slivers join the nearest particle, which another rank may have.
bool can_be_filled_in_parts(const Spec& spec);

/// The part of this rank, as fill() lays it; those of each rank are a block of a set.
/// @throws std::invalid_argument as fill() does, and if a set has more particles than there are numbers
std::vector<Particles> fill_together(const Spec& spec, const std::optional<Head>& head,
                                     const mesh::Quadtree* tree, Communicator& ranks);

} // namespace tremolo::mpm_domain
