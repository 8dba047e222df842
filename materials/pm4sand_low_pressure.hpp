#pragma once

// PM4Sand where the effective stress vanishes. The stress stays at p = p_min/5 at least, with the direction
// of its shear. Volumetric extension beyond that opens a gap and makes no stress; compression, and the
// dilation of shearing, first close the gap.

#include "materials/pm4sand_rates.hpp"

namespace tremolo::materials::pm4 {

/// The part of a strain increment that strains the skeleton of a point; the rest opens or closes its gap.
inline Strain skeleton_strain(State& state, const Stress& stress, Strain strain) {
  if (strain.volumetric < 0.0 && stress.p <= floor_pressure(state)) {
    state.gap -= strain.volumetric;
    strain.volumetric = 0.0;
  } else if (strain.volumetric > 0.0 && state.gap > 0.0) {
    const double closed = std::min(strain.volumetric, state.gap);
    state.gap -= closed;
    strain.volumetric -= closed;
  }
  return strain;
}

/// Keeps the pressure at or above its floor and, while there is a gap, at the floor.
/// @param stiffness  K + G/3, Pa: turns pressure into the volumetric strain it stands for
inline void hold_floor(State& state, Stress& stress, double stiffness) {
  const double floor = floor_pressure(state);
  if (stress.p >= floor && state.gap == 0.0) {
    return;
  }
  const double gap = state.gap + (floor - stress.p) / stiffness;
  state.gap = std::max(gap, 0.0);
  stress.p = gap >= 0.0 ? floor : floor - gap * stiffness;
}

} // namespace tremolo::materials::pm4
