#pragma once

// What particles whose water flows add up at the nodes beside mass, momentum and force
// (transfer/scatter.hpp):
//
//     m_f,i = sum S n rho_f V,      p_f,i = sum S n rho_f V (v_f + C_f (x_i - x)),
//     V_i = sum S V,                R_i = sum S V rho_f g/k,      f_i = sum V p_e grad S.
//
// Soil that lets no water enter adds to the resistance alone.

#include "mpm_domain/domain.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// Sets these sums to those of all particles, tied nodes folded.
/// @param nodes  that particles may touch
/// @param ties   rows of the prolongation whose tied nodes they touch
void scatter_water(Domain& domain, std::span<const NodeRange> nodes, std::span<const std::size_t> ties);

/// The momentum of the water alone.
void scatter_water_momenta(Domain& domain, std::span<const NodeRange> nodes,
                           std::span<const std::size_t> ties);

/// Sums up what water takes off the weight, in a domain without pore pressure.
void scatter_lift(Domain& domain, std::span<const NodeRange> nodes, std::span<const std::size_t> ties);

} // namespace tremolo::mpm_domain
