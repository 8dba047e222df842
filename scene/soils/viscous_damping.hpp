#pragma once

#include "scene/case.hpp"

namespace tremolo::scene {

/// beta of the viscous stress beta D_e : d eps/dt that gives domain and column `mpm` a damping ratio, s; 0
/// without damping, or where it has no frequency (damping_suits_models).
///
/// xi = beta w/2 (Chopra 2012, Dynamics of Structures, 4th ed., sec. 11.4): 2 xi/w at the reference
/// frequency; of Rayleigh's damping, xi = alpha/(2 w) + beta w/2 at two frequencies, the part 2 xi/(w_1 +
/// w_2).
/// @param ratio of critical
double damping_time(const Damping& damping, double ratio);

/// alpha of the other part, in proportion to mass, 2 xi w_1 w_2/(w_1 + w_2), 1/s; 0 under another model, and
/// where a wave comes up beyond the critical angle of the half-space: the rock's own motion, which that
/// damping is relative to, is none that a wave of its form has there.
double mass_damping(const Case& scene, double ratio);

/// The relaxation mechanisms that give soil a damping ratio; none under another model than `constant`, and
/// where it has no frequency.
/// @param ratio of critical
materials::Relaxation relaxation(const Damping& damping, double ratio);

/// Fraction of a layer's P-wave modulus that relaxes: 1, or G/M (shear alone) where there is pore pressure.
double relaxing_share_p(const Case& scene, const Layer& layer);

/// Whether damping acts in time: as viscous stress or by mechanisms.
bool acts_in_time(const Damping& damping, double ratio);

} // namespace tremolo::scene
