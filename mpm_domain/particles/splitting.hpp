#pragma once

// Particles that enter finer cells are cut in four, so that those cells do not run short of them. A particle
// of half side l at x, of mass m and volume V, becomes four of l/2, m/4 and V/4 at
//
//     x_k = x + (+-l/2, +-l/2),      v_k = v + C (x_k - x),
//
// with its stress, state and affine velocity C = B D^-1 (zero unless APIC); a box that follows the soil is
// cut likewise, M/4 each. The boxes of the four tile its own, so the mean of their weights is its weight, 1/4
// sum_k S_Ik = S_Ip and 1/4 sum_k G_Ik = G_Ip: mass, momentum and force of every node stay as they are.
// Positions, displacement and angular momentum stay too; the kinetic energy of C becomes that of the four.

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

/// Cuts every particle whose box lies in leaves of one level, finer than its own, and was at the start wider
/// than 3/4 of them; those that are to stay whole (Particles::whole) are passed over. Particles are out of
/// order afterwards: to be sorted. Those that leave fine cells again stay small.
/// @returns the number of particles that were cut
std::size_t split_particles(Ground& ground);

} // namespace tremolo::mpm_domain
