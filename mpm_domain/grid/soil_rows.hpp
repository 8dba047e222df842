#pragma once

#include "mpm_domain/spec/lattice.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;

/// For every row of nodes and every tile, the part from the first to the last node that particles may touch
/// until the next sort, including tied nodes and those that they follow: the range of passes over nodes. All
/// others are empty. Parts begin a multiple of four nodes after their row and end at another or with it, and
/// none reaches from tile to tile, so that sums in lanes have the same bits however far particles have moved
/// since the sort, and on whichever rank. A rank has the parts that its own particles touch, those of its own
/// tiles that others touch, and those that hold the shared nodes.
std::vector<NodeRange> find_soil_rows(const Ground& ground, std::span<const std::size_t> shared_nodes);

/// The rows of Ground::ties() whose tied nodes particles may touch until the next sort, in rising order; all
/// of a graded mesh, and all where ranks share the ground. A narrow periodic grid has many images that no
/// particle comes near.
std::vector<std::size_t> find_soil_ties(const Ground& ground);

} // namespace tremolo::mpm_domain
