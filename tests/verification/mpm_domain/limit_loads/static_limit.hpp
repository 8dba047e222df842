#pragma once

// Whether a body of soil carries its weight: the gravity stage comes to rest or it does not. Near the limit
// it takes its time; a body that fails keeps an unbalanced force of some thousandths of its weight.

#include "mpm_domain/gravity/gravity_stage.hpp"

namespace tremolo::mpm_domain::test {

inline constexpr double gravity = 9.81; // m/s2

/// Clay or sand without softening, Pa and rad.
inline materials::MohrCoulomb perfectly_plastic(const materials::Elasticity& elastic, double cohesion,
                                                double friction) {
  materials::MohrCoulomb law;
  law.elastic = elastic;
  law.cohesion_peak = law.cohesion_residual = cohesion;
  law.friction_peak = law.friction_residual = friction;
  return law;
}

/// @param patience  s of relaxation after which it has failed: well over what bodies that stand take, 5 %
/// away
///                  from their limit
inline bool carries_its_weight(const Spec& spec, double patience) {
  Domain domain(spec);
  try {
    relax_under_gravity(domain, {.residual = 1e-4, .max_time = patience}, [](long, double) {});
    return true;
  } catch (const NotAtRest&) {
    return false;
  }
}

} // namespace tremolo::mpm_domain::test
