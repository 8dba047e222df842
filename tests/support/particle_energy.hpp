#pragma once

// The energy of linear elastic particles, and of springs.

#include "mpm_domain/boundary/springs/ground_springs.hpp"
#include "mpm_domain/domain.hpp"

#include <utility>

namespace tremolo::test_support {

/// Elastic energy of linear elastic particles in their present stress, J/m.
inline double elastic_energy(const mpm_domain::Domain& domain) {
  double energy = 0.0;
  for (const mpm_domain::Particles& p : domain.sets) {
    const materials::Elasticity& e = materials::elasticity(p.law);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double squares = p.sxx[k] * p.sxx[k] + p.syy[k] * p.syy[k] + p.szz[k] * p.szz[k];
      const double products = p.sxx[k] * p.syy[k] + p.syy[k] * p.szz[k] + p.szz[k] * p.sxx[k];
      energy += p.volume[k] / e.young *
                (0.5 * squares - e.poisson * products + (1.0 + e.poisson) * p.sxy[k] * p.sxy[k]);
    }
  }
  return energy;
}

/// Of their velocities alone, J/m: what APIC's moments hold is not in it.
inline double kinetic_energy(const mpm_domain::Domain& domain) {
  double energy = 0.0;
  for (const mpm_domain::Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      energy += 0.5 * p.mass[k] * (p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k]);
  return energy;
}

/// Both, J/m.
inline double particle_energy(const mpm_domain::Domain& domain) {
  return kinetic_energy(domain) + elastic_energy(domain);
}

/// sum L (k_n d_n^2 + k_t d_t^2)/2 of the springs beside dashpots, J/m; 0 without any.
inline double energy_of_springs(const mpm_domain::Domain& domain) {
  const auto* const springs = domain.boundary.supports().find<mpm_domain::GroundSprings>();
  double energy = 0.0;
  for (std::size_t f = 0; springs != nullptr && f < domain.boundary.faces().size(); ++f)
    if (const auto* const of_face = springs->at(f)) {
      const auto [k, d] = std::pair(of_face->stiffness, of_face->moved);
      energy += 0.5 * of_face->length * (k.x * d.x * d.x + k.y * d.y * d.y);
    }
  return energy;
}

} // namespace tremolo::test_support
