#pragma once

// Operations on the nodes below the water table between the transfers, instead of or after those on nodes of
// dry soil (step/grid_update.hpp). All functions work on the rows of nodes that they are given. Nodes without
// water take part as dry ones. What they return are sums of one rank.
//
// The kinetic energy of both phases changes by
//
//     m_s a_s . v_s + m_f a_f . v_f = F' . v_s + m_f a_f . w,      m_f a_f = n (f - d w),
//
// velocities being means over the step. F' . v_s holds the power of stresses, boundary and weight; n f . w is
// the power of the excess pressure on the flow of water; the rest is what the drag dissipates.

#include "mpm_domain/tiles/totals.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// v_f- = p_f/m_f; that of the grains where there is no water.
/// @returns kinetic energy of the water, J/m
ExactSums<1> water_velocities(Ground& ground, std::span<const NodeRange> nodes);

/// Energies summed during the update of nodes, J/m.
struct MixtureUpdate {
  double kinetic; ///< of grains and water
  double gravity_work;
  double dashpot_relief; ///< as in GridUpdate
  double drag;           ///< dissipated by drag, and by closed faces

  explicit MixtureUpdate(const std::array<double, 4>& totals)
      : kinetic(totals[0]), gravity_work(totals[1]), dashpot_relief(totals[2]), drag(totals[3]) {}
};

/// v_s+ and v_f+ (mixture_kick.hpp).
/// @param dt time that the forces act for, s
/// @returns the parts of a MixtureUpdate
ExactSums<4> update_mixture(Ground& ground, double dt, std::span<const NodeRange> nodes);

/// The flux v_s + n w that changes pore pressures, of v+ (usl).
void find_flux(Ground& ground, std::span<const NodeRange> nodes);

/// Finds the flux of the velocities remapped from the particles' new momenta (musl). At impermeable nodes w =
/// 0, whatever neighbouring particles carry there: otherwise impermeable soil would take in water that no
/// force has moved.
/// @returns power of the excess pressure on the difference between the flow after the update and that of the
/// flux, W/m
ExactSums<1> remap_flux(Ground& ground, std::span<const NodeRange> nodes);

/// Power of the buoyancy and of the seepage force on the mean of the velocities before and after the update,
/// W/m. The update has booked the whole weight of what moves with the grains.
ExactSums<1> buoyancy_power(Ground& ground, std::span<const NodeRange> nodes);

/// Power of the buoyancy and the seepage force on the difference between the velocity after the update and
/// the remapped one, W/m.
ExactSums<1> buoyancy_remap_power(Ground& ground, std::span<const NodeRange> nodes);

} // namespace tremolo::mpm_domain
