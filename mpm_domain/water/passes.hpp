#pragma once

// Passes of pore water in a step. Below the water table, soil and water come to the grid together
// (water_scatter.hpp); where there is a pore pressure p,
//
//   pressure:    p += -dt (K_f/n) div(v_s + n w)                          (pore_pressure.hpp)
//
// of the velocities that strain the soil. Where water does not flow, w = 0. Where it flows, it has a velocity
// of its own and takes part in the transfers of the soil,
//
//   velocities:  v_f- = p_f/m_f
//   update:      v_s+, v_f+ with Darcy's drag                             (mixture_kick.hpp)
//   gather:      v_s, v_f of particles, and their momenta back to the grid (musl)
//   remap:       the flux v_s + n w of the remapped velocities            (musl)
//
// Water has one clock.

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// Scatter and gather in the place of those of dry soil (transfer/passes/passes.hpp).
std::vector<Pass> wet_transfer_passes(Ground& ground);

/// All else. The remap comes after the books of the nodes, to which it adds.
std::vector<Pass> water_passes(Ground& ground);

} // namespace tremolo::mpm_domain
