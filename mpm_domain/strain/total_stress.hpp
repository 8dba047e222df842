#pragma once

// The stress that forces see: that of the law, which is effective below the water table, that of viscous
// damping, and the excess pressure of pore water (pore_water.hpp),
//
//     sigma = sigma' + sigma_v - p_e I.

#include "mpm_domain/kernel/lanes.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"

namespace tremolo::mpm_domain {

/// In-plane components, Pa.
struct TotalStress {
  double xx, yy, xy;
};
struct TotalStressLanes {
  Lanes xx, yy, xy;
};

inline bool has_more_than_law_stress(const Particles& p) {
  return p.traits.damped || p.traits.wet;
}

/// p_e of a group of wet particles from k on, Pa
template <typename Group>
[[gnu::always_inline]] inline Lanes excess_pressure(const Particles& p, std::size_t k, Group group) {
  // In this order of the arguments a NaN pressure stays NaN.
  return larger(all(p.water->fluid.cavitation_pressure), group.load(&p.pore_pressure[k])) -
         rest_pressure(p, k, group);
}

/// The stress of a group of particles from k on.
template <typename Group>
[[gnu::always_inline]] inline TotalStressLanes total_stress(const Particles& p, std::size_t k, Group group) {
  TotalStressLanes s{group.load(&p.sxx[k]), group.load(&p.syy[k]), group.load(&p.sxy[k])};
  if (p.traits.damped) {
    s.xx += group.load(&p.viscous_xx[k]);
    s.yy += group.load(&p.viscous_yy[k]);
    s.xy += group.load(&p.viscous_xy[k]);
  }
  if (p.traits.wet) {
    const Lanes excess = excess_pressure(p, k, group);
    s.xx -= excess;
    s.yy -= excess;
  }
  return s;
}

/// The stress of one particle.
inline TotalStress total_stress(const Particles& p, std::size_t k) {
  const auto [xx, yy, xy] = total_stress(p, k, FewerThanFour(1));
  return {xx[0], yy[0], xy[0]};
}

} // namespace tremolo::mpm_domain
