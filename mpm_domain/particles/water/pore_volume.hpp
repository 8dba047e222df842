#pragma once

#include "mpm_domain/kernel/lanes.hpp"
#include "mpm_domain/particles/particles.hpp"

namespace tremolo::mpm_domain {

/// Whether the pressure of its water follows the change of volume.
inline bool takes_pressure(const Particles& p) {
  return p.traits.wet && !p.drains;
}

/// V n of a group of wet particles from k on, m2
template <typename Group>
Lanes pore_volume(const Particles& p, std::size_t k, Group group) {
  return group.load(&p.volume[k]) - p.water->grains_per_mass * group.load(&p.mass[k]);
}

/// V n of one particle, m2
inline double pore_volume(const Particles& p, std::size_t k) {
  return p.volume[k] - p.water->grains_per_mass * p.mass[k];
}

} // namespace tremolo::mpm_domain
