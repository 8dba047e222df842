#pragma once

// Pore pressure. With n_i = m_f,i/(rho_f V_i) and w_i = v_f,i - v_s,i at nodes, a particle's water is
// compressed at the rate
//
//     theta_p = sum_i (v_s,i + n_i w_i) . grad S_ip,          dp_p = -dt (K_f/n_p) theta_p,
//
// which is the dual of the water's force per unit of its volume: drag aside, water and grains exchange
// exactly the energy that the pressure stores, at any porosity.
//
// Every particle would then require its own change of volume, more than nodes can give: pressures would
// oscillate within and between cells by several times the load, and shear waves in saturated soil would be
// too fast by half. So what the water is compressed by, e = -dt theta/n = dp/K_f, is filtered with the pore
// volumes W = V n as weights, by C A C:
//
//     C:  the mean of the particle's cell, sum W e / sum W,
//     A:  e_i = sum_p W S_ip e_p / sum_p W S_ip,    then e_p = sum_i S_ip e_i.
//
// Particles that stand together in a cell read and bring the same e. They go through A as one run, with their
// shares sum W S of the nodes (tiles/cell_runs.hpp), which come with the pore volumes of the nodes.
//
// C and A are self-adjoint for these weights, and so is C A C, which A C is not: the filter can add no
// energy. It keeps sum W e = -dt sum V theta: no water is lost.
//
// A cell then has one pressure. Particles that cross into another cell take part in its increments, so that
// pressures would come to differ within cells by what neighbours differ by, more with every cycle: nodes feel
// only the mean of it, and nothing would even it out. So the last C also takes the mean of the excess p_e,
//
//     p = p_0 + C (p_e + K_f A C e).
//
// Where particles stay in their cells it changes nothing. It keeps sum W p_e, and the energy sum W p_e^2/2
// K_f can only fall. What a cell gives another by it is the compression of the water alone, p_e/K_f: balance
// of momentum brings back any pressure that skeleton and weight require.

#include "mpm_domain/tiles/totals.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// What waits in a set of the ground.
WaitingPressures& waiting_of(Ground& ground, const Particles& p);

/// Brings the pore pressures of all wet particles that do not drain in a static stage over a step of dt (s),
/// before they move. The nodes have the
/// sums of scatter_mixture().
/// @param flux_x,flux_y  v_s + n w at the nodes, tied ones too, m/s
/// @param ties           rows of the prolongation whose tied nodes particles touch
/// @returns the work that the pressures take up, J/m
ExactSums<1> update_pressures(Ground& ground, double dt, const NodeField& flux_x, const NodeField& flux_y,
                              std::span<const NodeRange> nodes, std::span<const std::size_t> ties);

} // namespace tremolo::mpm_domain
