#pragma once

// Changes of an elastic box (box_run.hpp) into the models whose bits are compared.

#include "mpm_domain/spec/spec.hpp"

namespace tremolo::test_support {

/// Clay weak enough to yield in the wave.
inline void yield(mpm_domain::Spec& spec) {
  materials::MohrCoulomb clay;
  clay.elastic = materials::elasticity(spec.soils.front().law);
  clay.cohesion_peak = clay.cohesion_residual = 100.0;
  spec.soils.front().law = clay;
}

inline void add_layers(mpm_domain::Spec& spec) {
  using enum mpm_domain::Side;
  spec.matched_sides = {left, right, base};
}

} // namespace tremolo::test_support
