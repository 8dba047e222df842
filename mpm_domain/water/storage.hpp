#pragma once

#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/transfer/lanes.hpp"

namespace tremolo::mpm_domain {

/// W = V n/K_f of a group of wet particles from k on: what their pores hold more for each Pa, m2/Pa.
template <typename Group>
Lanes storage_of(const Particles& p, std::size_t k, Group group) {
  const PoreWater& water = *p.water;
  return (group.load(&p.volume[k]) - water.grains_per_mass * group.load(&p.mass[k])) /
         water.fluid.bulk_modulus;
}

/// Of one particle.
inline double storage_of(const Particles& p, std::size_t k) {
  return storage_of(p, k, FewerThanFour(1))[0];
}

} // namespace tremolo::mpm_domain
