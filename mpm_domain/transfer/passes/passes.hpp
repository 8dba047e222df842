#pragma once

// The transfers of a step between particles and grid, clock by clock. Where the update of stress comes last:
//
//   scatter:  m, p, f from the particles of the clocks that begin a step of theirs
//   stress:   v_p from v+, x_p += dt v+(x_p), strain and stress from v+
//
// With remapped velocity, of the clocks that end a step of theirs with the tick:
//
//   gather:   v_p from v+, and p from v_p again
//   stress:   x_p += dt v+(x_p), strain and stress from u
//
// Where soil is wet, scatter is part of water/passes.hpp, and where water flows so is gather. With reduced
// dispersion forces are scattered after masses, and sharpened (sharp_transfer.hpp).

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

std::vector<Pass> transfer_passes(Ground& ground);

/// The additional pass of reduced dispersion: u <- Q u after all other changes of u (sharp_transfer.hpp).
std::vector<Pass> sharp_passes(Ground& ground);

} // namespace tremolo::mpm_domain
