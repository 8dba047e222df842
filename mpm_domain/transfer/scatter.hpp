#pragma once

#include "mpm_domain/domain.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// What a scatter pass brings to the nodes.
enum class ScatterPart {
  motion,
  momentum, ///< of motion without the masses, which stay while particles stay where they are
  force,
  both, ///< motion and force
};

/// Particles to grid, in three moves that the step puts together clock by clock:
///
///   motion:  m_i = sum_p S_ip m_p,    p_i = sum_p S_ip m_p (v_p + C_p (x_i - x_p))    (C only with APIC)
///   force:   f_i = sum_p (S_ip m_p g - V_p sigma_p grad S_ip)
///
/// sigma_p being the stress of the law and that of viscous damping, where the soil has any.
///
/// Every tile of particles adds up sums of its own, which the nodes then add up in the order of tiles
/// (tile_sums.hpp): every node receives its contributions in one order for any number of threads.

/// Makes the sums of a part zero.
void clear(Domain& domain, ScatterPart part, std::span<const NodeRange> nodes);
/// Adds what the particles of a clock bring; tied nodes keep their share.
void add_particles(Domain& domain, ScatterPart part, int clock);
/// Hands on what tied nodes have collected.
/// @param rows of the prolongation
void fold(Domain& domain, ScatterPart part, std::span<const std::size_t> rows);

/// All three for all particles and nodes.
void scatter(Domain& domain, ScatterPart part);

} // namespace tremolo::mpm_domain
