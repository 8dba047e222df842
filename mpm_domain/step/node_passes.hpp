#pragma once

// Passes over the nodes of each clock (grid_update.hpp), and the energy booked for the forces on them:
//
//   velocities:  v- = p/m
//   update:      m (v+ - v-) = kick f                                (water/passes.hpp where water flows)
//   books:       kinetic = sum K(v+)
//   remap:       u = p/m of the new momenta                          (musl)
//
// With the trapezoidal rule, the work of the stresses is booked on the mean of this step's remapped velocity
// u and the last one, which is v-. The kinetic energy grows by their power on (v- + v+)/2. Half of their
// power on v+ - u is therefore booked as transfer. The work of weight and boundary is booked on v+.

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

std::vector<Pass> node_passes(Ground& ground);

/// These passes must follow those of the boundary, which contributes to the power of the forces on v+ - u.
std::vector<Pass> node_books(const Ground& ground);

} // namespace tremolo::mpm_domain
