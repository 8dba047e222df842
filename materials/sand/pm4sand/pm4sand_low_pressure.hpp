#pragma once

// PM4Sand where the effective stress vanishes. The stress stays at p = p_min/5 at least, with the direction
// of its shear. Volumetric extension beyond that opens a gap and makes no stress; compression, and the
// dilation of shearing, first close the gap.

#include "materials/sand/pm4sand/pm4sand_rates.hpp"

namespace tremolo::materials::pm4 {

/// The part of a strain increment that strains the skeleton of a point; the rest opens or closes its gap.
inline Strain skeleton_strain(const Initial& start, const Stress& stress, Strain strain, double& gap) {
  if (strain.volumetric < 0.0 && stress.p <= floor_pressure(start)) {
    gap -= strain.volumetric;
    strain.volumetric = 0.0;
  } else if (strain.volumetric > 0.0 && gap > 0.0) {
    const double closed = std::min(strain.volumetric, gap);
    gap -= closed;
    strain.volumetric -= closed;
  }
  return strain;
}

/// Keeps the pressure at or above its floor and, while there is a gap, at the floor.
/// @param stiffness  K + G/3, Pa: turns pressure into the volumetric strain it stands for
inline void hold_floor(const Initial& start, Stress& stress, double& gap, double stiffness) {
  const double floor = floor_pressure(start);
  if (stress.p >= floor && gap == 0.0)
    return;
  const double opening = gap + (floor - stress.p) / stiffness;
  gap = std::max(opening, 0.0);
  stress.p = opening >= 0.0 ? floor : floor - opening * stiffness;
}

} // namespace tremolo::materials::pm4
