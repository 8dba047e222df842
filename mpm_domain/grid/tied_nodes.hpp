#pragma once

// Nodes whose motion is that of others, Ground::ties(): the images of a periodic grid (periodic_sides.hpp)
// and the tied nodes of a graded mesh (graded_mesh.hpp), among which are its images. With P the prolongation,
// tied nodes hand on what they have collected, P^T, and take over the motion of the nodes that they follow,
// P.

#include "mpm_domain/ground.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// Sets the fields of a group to zero at the given nodes.
void clear(Ground& ground, NodeGroup group, std::span<const NodeRange> nodes);

/// Adds to the nodes that they follow what tied nodes have in the fields of a group, and leaves them empty.
/// @param rows of the prolongation
void fold(Ground& ground, NodeGroup group, std::span<const std::size_t> rows);

/// Gives tied nodes the fields of a group of the nodes that they follow.
void prolong(Ground& ground, NodeGroup group, std::span<const std::size_t> rows);

/// `fold` and `prolong` for all tied nodes.
void fold(Ground& ground, NodeGroup group);
void prolong(Ground& ground, NodeGroup group);

/// The images of a periodic grid of one lattice, tied to their original columns.
Prolongation images_of(const Grid& grid);

} // namespace tremolo::mpm_domain
