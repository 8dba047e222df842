#pragma once

// The part of Rayleigh's damping that is proportional to mass, alpha m on the velocity relative to the motion
// v_ref that the rock below would have without soil on top (Chopra 2012, Dynamics of Structures, sec. 11.4;
// freefield/base_motion.hpp). It is split off the step, which needs no other length for it: before particles
// come to the grid, over the time dt that forces act for,
//
//     v <- v_ref + e (v - v_ref),   B <- e B,   e = exp(-alpha dt),
//
// B the affine velocity. Where pore water flows, alpha acts on the mass of grains and water, and grains alone
// take it, as in columns (freefield/twophase).
//
// Energy. Of what a particle's kinetic energy loses, m/2 (v - v_ref)^2 (1 - e^2) is dissipated, booked as
// viscous, and the rest, m (v - v_ref) . v_ref (1 - e), is work that the rock gives or takes: input.

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// None where no soil has Spec::Soil::mass_damping.
std::vector<Pass> mass_damping_passes(Ground& ground);

} // namespace tremolo::mpm_domain
