#pragma once

// The pressure of the undisturbed water at the present positions of particles,
//
//     p_0 = gamma (h - y),
//
// negative above the phreatic surface, where wet soil may have moved. Particles carry the head h only where
// it varies (trait seeping); follow_head() keeps it up to date.

#include "mpm_domain/head/head.hpp"
#include "mpm_domain/kernel/lanes.hpp"
#include "mpm_domain/particles/particles.hpp"

namespace tremolo::mpm_domain {

/// p_0 of a group of particles of a set under water from k on, Pa
template <typename Group>
[[gnu::always_inline]] inline Lanes rest_pressure(const Particles& p, std::size_t k, Group group) {
  const PoreWater& water = *p.water;
  const Lanes y = group.load(&p.y[k]);
  return p.traits.seeping ? water.unit_weight * (group.load(&p.head[k]) - y)
                          : water.unit_weight * (water.level - y);
}

/// p_0 of one of them, Pa
inline double rest_pressure(const Particles& p, std::size_t k) {
  const PoreWater& water = *p.water;
  return water.unit_weight * ((p.traits.seeping ? p.head[k] : water.level) - p.y[k]);
}

/// p_e of one of them, Pa
inline double excess_pressure(const Particles& p, std::size_t k) {
  return p.water->pressure(p.pore_pressure[k]) - rest_pressure(p, k);
}

/// Takes the head at the present positions of particles [begin, end) of a set with trait seeping.
void follow_head(Particles& p, std::size_t begin, std::size_t end, const Head& head);

/// Gives the particles of a set under water the head, and the pressure that goes with it.
void take_head(Particles& p, const Head& head);

} // namespace tremolo::mpm_domain
