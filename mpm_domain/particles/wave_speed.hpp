#pragma once

// Speeds of compression waves in particles, in their present stress. A law gives the speed for the density
// that it knows, rho_law c^2 = M; the particles' own density may be that of dry soil, of grains alone, or of
// grains and water.

#include "coupler/eq6/boundary_traction.hpp"
#include "mpm_domain/particles/particles.hpp"

namespace tremolo::mpm_domain {

/// The largest speeds that bound the step of particles of a range, m/s.
struct FastestWaves {
  /// Below the water table that of grains and water without drag where water flows, and that of both together
  /// where it does not.
  double in_soil = 0.0;
  /// For constant pore pressures: the skeleton alone, with the particles' mass.
  double in_skeleton = 0.0;
};
FastestWaves fastest_waves(Particles& particles, const ParticleRange& range);

/// Impedances of the ground at a particle to waves so slow that pore water follows them.
struct Impedances {
  double p = 0.0;       ///< rho c_p, Pa s/m
  double s = 0.0;       ///< rho c_s, Pa s/m
  double density = 0.0; ///< rho, kg/m3
};
Impedances impedances(Particles& particles, std::size_t k);

} // namespace tremolo::mpm_domain
