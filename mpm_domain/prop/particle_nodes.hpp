#pragma once

#include "mpm_domain/kernel/node_share.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;

/// Adds the nodes that a particle touches, tied ones replaced by those that they follow, with a share (1) of
/// its weights S.
/// @param k  the particle's present index in its set
void add_nodes(const Ground& ground, std::size_t set, std::size_t k, double share,
               std::vector<NodeShare>& nodes);

} // namespace tremolo::mpm_domain
