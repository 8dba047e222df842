#pragma once

// Where the head h of the undisturbed water varies, soil and water together feel the seepage force, per
// volume
//
//     j = -gamma grad h,      f_i = sum_p V_p S_ip j_p,
//
// beside the weight under water: gamma_sat e_g - grad p_0 = gamma' e_g + j for p_0 = gamma (h - y). What
// drives the water alone is the excess pressure still (water_scatter.hpp). Its velocity w counts from the
// steady flow then, which is a solution by itself: gamma grad h balances the drag of that flow, and div (k
// grad h) = 0.

#include "mpm_domain/ground.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// Takes the head at the particles' present positions.
void follow_head(Ground& ground);

/// Sums up the force at the nodes, tied nodes folded.
/// @param nodes  that particles may touch
/// @param ties   rows of the prolongation whose tied nodes they touch
void scatter_seepage(Ground& ground, std::span<const NodeRange> nodes, std::span<const std::size_t> ties);

/// Adds what was summed up to the forces of nodes.
void add_seepage(Ground& ground, std::span<const NodeRange> nodes);

} // namespace tremolo::mpm_domain
