#pragma once

// Particles that have left fine cells are joined, four to one, as they were before a cut (splitting.hpp).
// Four of half side l, of mass m_k and volume V_k at x_k, become one of 2l, m = sum m_k and V = sum V_k at
//
//     x = sum m_k x_k / m,      v = sum m_k v_k / m,
//
// with the mean displacement by mass and the mean stress by volume; boxes that follow the soil give it their
// second moments about x, M = 1/4 sum (M_k + 3 (x_k - x)(x_k - x)^T). With APIC
//
//     B = sum m_k/m (B_k + v_k (x_k - x)^T),
//
// which is what the one would have gathered itself: the boxes of the four tile its own, 1/4 sum S_Ik = S_Ip.
// Mass, volume, momentum, angular momentum and places stay, and four from one cut give it back. Of the
// kinetic energy, 1/2 sum m_k |v_k - v|^2 is lost except for what B holds; the ledger finds it in the grid's
// energy, as all that happens between grid and particles, and books it as transfer.

#include "mpm_domain/domain.hpp"

namespace tremolo::mpm_domain {

/// Joins every four particles
/// - that were the quarters of a square of the coarser lattice at the start, as those of a cut one were, and
///   still fill a square, each coordinate within 20 % of l,
/// - which lies in leaves of coarser levels than theirs,
/// - in soil that has never yielded: every state variable is what it was at the start. Soil that remembers
///   elastic strain too, like the hysteretic laws, is thus left alone,
/// - and whose stress is within 5 % of their mean (Frobenius norm), or within 1e-9 E, which is rounding.
///
/// Those that are to stay whole (Particles::whole) are passed over. Particles are out of order afterwards: to
/// be sorted.
/// @returns the number of particles that came of it
std::size_t join_particles(Domain& domain);

} // namespace tremolo::mpm_domain
