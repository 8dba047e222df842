#pragma once

#include "mpm_domain/ground.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// The sums that a scatter pass computes at the nodes.
enum class ScatterPart {
  motion,   ///< mass and momentum
  momentum, ///< momentum alone: masses stay the same while particles stay where they are
  force,
  both, ///< motion and force
};

/// Particles to grid, in three moves that the step puts together clock by clock:
///
///   motion:  m_i = sum_p S_ip m_p,    p_i = sum_p S_ip m_p (v_p + C_p (x_i - x_p))    (C only with APIC)
///   force:   f_i = sum_p (S_ip m_p g - V_p sigma_p grad S_ip)
///
/// where sigma_p is the stress of the law and that of viscous damping, if the soil has any.
///
/// The particles of every tile are added up by themselves, and the nodes then add up the tiles in their order
/// (tile_sums.hpp). So every node receives its contributions in the same order for any number of threads.

/// Sets the sums of a part to zero.
void clear(Ground& ground, ScatterPart part, std::span<const NodeRange> nodes);
/// Adds the contributions of a clock's particles. Tied nodes keep theirs until fold().
void add_particles(Ground& ground, ScatterPart part, int clock);
/// Moves the sums of tied nodes to the nodes that they follow.
/// @param rows of the prolongation: the tied nodes that are meant
void fold(Ground& ground, ScatterPart part, std::span<const std::size_t> rows);

/// clear(), add_particles() and fold() for all particles and nodes.
void scatter(Ground& ground, ScatterPart part);

} // namespace tremolo::mpm_domain
