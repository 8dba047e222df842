#pragma once

// Mass-proportional Rayleigh damping: a force alpha m on the velocity relative to v_ref, the motion that the
// rock below would have without soil on top (Chopra 2012, Dynamics of Structures, sec. 11.4;
// freefield/base_motion.hpp). The damping is integrated separately (operator splitting), so that it does not
// limit the step: before the particles are mapped to the grid, over the time dt for which forces act,
//
//     v <- v_ref + e (v - v_ref),   B <- e B,   e = exp(-alpha dt),
//
// where B is the affine velocity. Where pore water flows, alpha acts on the mass of grains and water, but its
// force is carried by the grains alone, as in columns (freefield/twophase).
//
// Energy. A particle's kinetic energy decreases by two terms: m/2 (v - v_ref)^2 (1 - e^2) is dissipated and
// booked as viscous; m (v - v_ref) . v_ref (1 - e) is exchanged with the rock and booked as input.

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// The passes are empty if no soil has Spec::Soil::mass_damping.
std::vector<Pass> mass_damping_passes(Ground& ground);

} // namespace tremolo::mpm_domain
