#pragma once

// Constant damping (materials/relaxation/relaxation.cpp): beside the stress of its law, for the share G_R/G
// of the strain, soil bears the stress q_j of its relaxation mechanisms. They follow the increments of the
// law's stress and turn with the soil (materials/tensor/objective_rate.hpp), so that a rotation alone strains
// nothing:
//
//     q_j -> kept_j Q q_j Q^T + taken_j (sigma - Q sigma_before Q^T).
//
// Where soil has pore pressure they bear the deviator in the plane alone, (sxx - syy)/2 and sxy: a mean
// stress of theirs would be effective stress that goes on relaxing for seconds. Increments of strain and of
// stress belong to the same time, so that nothing lags, and the step that is stable is that of the stiffness
// G_U.

#include "mpm_domain/particles/particles.hpp"

#include <array>
#include <cstddef>

namespace tremolo::mpm_domain {

/// Strain increments of the particles of a range, and how they turn; gxy engineering strain.
struct TurningStrain {
  const double *exx, *eyy, *gxy, *wxy;
};

/// Fills what the laws of particles see: of wet soil all of the change of area in the plane, and the share of
/// the rest.
void see_share(const Particles& particles, std::size_t count, const TurningStrain& all, double* exx,
               double* eyy, double* gxy);

/// Lets the mechanisms of particles follow their laws, after these.
/// @param before  in-plane stress of the laws before the step, Pa
/// @param all     strain and rotation that the laws have followed
/// @param moved   strain by which the particles have moved, on which the mechanisms do work
/// @param dt      s
/// @returns the work of the mechanisms' stress, (V q + V' q') : de/2, J/m
double relax(Particles& particles, const ParticleRange& range, const std::array<const double*, 3>& before,
             const TurningStrain& all, const TurningStrain& moved, double dt);

/// Forgets all stress that soil has borne besides that of its laws.
void forget(Particles& particles);

} // namespace tremolo::mpm_domain
