#pragma once

// Viscous damping at small strain: beside the stress of its law, soil bears
//
//     sigma_v = beta D_e : d eps/dt,
//
// D_e being the law's elastic tangent in its present state, which for sand falls with pressure, stress ratio
// and fabric. A wave of angular frequency w then loses the fraction xi = beta w/2 of
// critical damping, S and P alike (Kelvin and Voigt; Chopra 2012, Dynamics of Structures, 4th ed., sec. 11.4:
// damping in proportion to stiffness). Columns do the same (freefield/profile.hpp).
//
// Strain increments belong to the middle of a step, and so does the stress that follows from them; forces
// take it at the end of the step. This lag of dt/2 changes frequencies by the fraction xi w dt/2 and the
// damping by xi w dt, and it limits the step (spec/limits.hpp), by the stiffness that sand would have without
// what stress ratio and fabric take from it.

#include "mpm_domain/kernel/lanes.hpp"
#include "mpm_domain/particles/particles.hpp"

namespace tremolo::mpm_domain {

/// Growth factor of a volume, det(I + A) to second order in the dilation exx + eyy.
inline Lanes growth(const Lanes& dilation) {
  return 1.0 + dilation * (1.0 + 0.5 * dilation);
}

/// Strain increments of the particles of a range; gxy engineering strain.
struct StrainIncrements {
  const double *exx, *eyy, *gxy;
};

/// The viscous stress of particles of a damped set for the increments of a step of dt (s). To be called
/// before the volumes follow the increments.
/// @param seen   the increments that the law sees, whose rate the stress takes: soil that is not to lock must
///               not be held by its damping either
/// @param moved  those by which the particles have moved, which it works on
/// @param ratios  materials::stiffness_ratios() before the law has followed the increments, one a particle;
/// null:
///                1
/// @returns the work that the viscous stresses dissipate, (V s + V' s') : de/2 of those before and after, J/m
double damp(Particles& particles, const ParticleRange& range, const StrainIncrements& seen,
            const StrainIncrements& moved, const double* ratios, double dt);

} // namespace tremolo::mpm_domain
