#pragma once

// Nodes whose motion is that of others: the images of a periodic domain (periodic_sides.hpp) and the tied
// nodes of a graded mesh (graded/graded_mesh.hpp), among which are its images.

#include "mpm_domain/domain.hpp"

#include <initializer_list>

namespace tremolo::mpm_domain {

/// Adds what tied nodes have collected (mass and momentum, momentum alone, or forces) to the nodes that they
/// follow, P^T, and leaves the tied ones empty.
void fold_motion(Domain& domain);
void fold_momentum(Domain& domain);
void fold_forces(Domain& domain);

/// Gives tied nodes what the nodes that they follow have in some fields, velocities or accelerations, P.
void copy_to_tied(Domain& domain, std::initializer_list<NodeField*> fields);

} // namespace tremolo::mpm_domain
