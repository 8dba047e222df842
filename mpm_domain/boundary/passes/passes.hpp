#pragma once

// Passes of the boundary in a step (boundary.hpp), once per step or at every tick:
//
//   scatter:   the soil at the faces is read
//   exchange:  v^m of the faces goes out, v^ff and sigma^ff come in       (once)
//   supports:  what stands behind the faces steps with them               (once)
//   forces:    f += l W t, with t of Eq. (6)
//   books:     work of the parts of t on (v- + v+)/2
//   remap:     power of the boundary's forces on u - v+ is left out of that of the nodes (musl)

#include "mpm_domain/boundary/boundary.hpp"
#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// The passes of the faces, and of the supports behind them.
/// @throws std::invalid_argument if there are faces and nobody gives their free field
std::vector<Pass> face_passes(Ground& ground, Boundary& boundary, FreeFieldSource free_field);

} // namespace tremolo::mpm_domain
