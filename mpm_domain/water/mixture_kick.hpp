#pragma once

// One component of the momentum balances at a node, with m_s the mass of what moves with the grains, m_f that
// of water which flows, V the volume of soil that it flows in, n = m_f/(rho_f V), M = m_s + m_f, F the force
// on soil and water together, f = sum V p_e grad S that on water per unit of water volume, and w = v_f - v_s:
//
//     M_f a_f = f - d w,        m_s a_s + m_f a_f = F' = F M/(M + dt C/2),      M_f = rho_f V,
//
// C being the dashpots lumped to the node (grid_update.hpp), d = n sum V (rho_f g/k) S Darcy's drag. With
// r = m_f/m_s, b = (1 + r) f/M_f - F'/m_s and lambda = d/M_f (1 + r), backward Euler in the drag alone gives
//
//     w+ = (w- + dt b)/(1 + lambda dt),
//     a_s = (F' - m_f (w+ - w-)/dt)/M,      a_f = a_s + (w+ - w-)/dt.
//
// It conserves the momentum of both together to rounding, its steady flow is that of Darcy for any step, and
// the drag never limits the step (Zienkiewicz and Shiomi 1984, Int. J. Numer. Anal. Meth. Geomech. 8, 71-96;
// the drag is implicit as in Ceccato et al. 2018, Comput. Geotech. 102).
// Where water may not pass, w+ = 0, and where there is no water w has no meaning: then a_f = a_s.

#include "mpm_domain/kernel/lanes.hpp"

namespace tremolo::mpm_domain {

/// Forces and drag on a velocity component at four nodes.
struct MixtureNodes {
  Lanes solid_mass;  ///< m_s, kg/m
  Lanes water_mass;  ///< m_f, kg/m
  Lanes full_water;  ///< M_f = rho_f V, kg/m
  Lanes resistance;  ///< sum V (rho_f g/k) S, Pa s
  LaneMask has_soil; ///< whether the node is not empty
  LaneMask has_water;
};

struct MixtureKick {
  Lanes solid;   ///< a_s, m/s2
  Lanes water;   ///< a_f, m/s2
  Lanes mixture; ///< F'/M, m/s2
};

/// @param force    F, N/m
/// @param dashpot  C, Pa s
/// @param pull     f, N/m
/// @param w        v_f- - v_s-, m/s
/// @param open     1, or 0 where water may not pass
inline MixtureKick kick_mixture(const MixtureNodes& nodes, const Lanes& force, const Lanes& dashpot,
                                const Lanes& pull, const Lanes& w, const Lanes& open, double dt) {
  const Lanes one = all(1.0);
  const Lanes water = choose(nodes.has_water, nodes.water_mass, Lanes{});
  const Lanes total = choose(nodes.has_soil, nodes.solid_mass + water, one);
  const Lanes mixture = choose(nodes.has_soil, force / (total + 0.5 * dt * dashpot), Lanes{});
  const Lanes per_solid = 1.0 / choose(nodes.has_soil, nodes.solid_mass, one);
  const Lanes full = choose(nodes.has_water, nodes.full_water, one);
  const Lanes grown = 1.0 + water * per_solid;
  const Lanes b = grown * pull / full - mixture * total * per_solid;
  const Lanes drag = water / full * nodes.resistance; // d
  const Lanes after = open * (w + dt * b) / (1.0 + dt * grown * drag / full);
  const Lanes relative = choose(nodes.has_water, (after - w) / dt, Lanes{});
  const Lanes solid = mixture - water / total * relative;
  return {solid, solid + relative, mixture};
}

} // namespace tremolo::mpm_domain
