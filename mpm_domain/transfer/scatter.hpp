#pragma once

#include "mpm_domain/domain.hpp"

namespace tremolo::mpm_domain {

/// What a scatter pass brings to the nodes.
enum class ScatterPart {
  motion,
  momentum, ///< of motion without the masses, which stay while particles stay where they are
  force,
  both, ///< motion and force
};

/// Particles to grid; sums of the chosen part are zeroed first.
///
///   motion:  m_i = sum_p S_ip m_p,    p_i = sum_p S_ip m_p (v_p + C_p (x_i - x_p))    (C only with APIC)
///   force:   f_i = sum_p (S_ip m_p g - V_p sigma_p grad S_ip)
///
/// Blocks of rows are scattered in two colours, so no two threads write one node and every node receives its
/// contributions in the same order for any thread count.
void scatter(Domain& domain, ScatterPart part);

/// Adds what the particles of one clock bring to what the nodes hold; tied nodes keep their part.
void scatter_clock(Domain& domain, ScatterPart part, int clock);

} // namespace tremolo::mpm_domain
