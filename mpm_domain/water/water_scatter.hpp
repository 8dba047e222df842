#pragma once

// Sums of submerged particles at the nodes in addition to those of all soil (transfer/scatter.hpp): where
// water flows
//
//     m_f,i = sum S n rho_f V,      p_f,i = sum S n rho_f V (v_f + C_f (x_i - x)),
//     V_i = sum S V,                R_i = sum S V rho_f g/k,      f_i = sum V p_e grad S,
//
// and everywhere the buoyancy, NodeFields::buoyancy, and the pore volumes, sum S n V. Impermeable soil adds a
// resistance larger than any drag, so that no water passes the nodes that it touches. Soil and water are
// scattered in one pass with the same weights.

#include "mpm_domain/ground.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// Resistance that impermeable soil adds to nodes, per volume: beyond all drag of soil, Pa s/m2
inline constexpr double sealed = 1e30;

/// Sets the sums of soil and water to those of all particles, tied nodes folded.
/// @param nodes  that particles may touch
/// @param ties   rows of the prolongation whose tied nodes they touch
void scatter_mixture(Ground& ground, std::span<const NodeRange> nodes, std::span<const std::size_t> ties);

/// Gives particles the velocities of grains and water that flows (water_gather.hpp) and sums up their new
/// momenta alone, tile by tile.
void exchange_mixture_velocities(Ground& ground, std::span<const NodeRange> nodes,
                                 std::span<const std::size_t> ties);

} // namespace tremolo::mpm_domain
