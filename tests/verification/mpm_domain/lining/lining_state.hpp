#pragma once

// What tests of linings measure in a domain.

#include "mpm_domain/domain.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

/// Mean axial force of a beam's elements, N/m.
inline double mean_thrust(const Beam& beam) {
  double sum = 0.0;
  for (std::size_t e = 0; e < beam.elements().size(); ++e)
    sum += beam.forces(e).axial / static_cast<double>(beam.elements().size());
  return sum;
}

/// Speed of the fastest particle, m/s.
inline double fastest_particle(const Domain& domain) {
  double fastest = 0.0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      fastest = std::max(fastest, std::hypot(set.vx[k], set.vy[k]));
  return fastest;
}

} // namespace tremolo::mpm_domain
