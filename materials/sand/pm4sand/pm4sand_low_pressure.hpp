#pragma once

// PM4Sand where the effective stress vanishes. The stress stays at p = p_min/5 at least, with the direction
// of its shear. Volumetric extension beyond that opens a gap and makes no stress; compression, and the
// dilation of shearing, first close the gap.

#include "materials/sand/pm4sand/pm4sand_rates.hpp"

namespace tremolo::materials::pm4 {

/// The part of a strain increment that strains the skeleton of points; the rest opens or closes their gaps.
inline Strains skeleton_strain(const Initials& start, const Stresses& stress, const Strains& strain,
                               Lanes& gap) {
  const Lanes v = strain.volumetric;
  const LaneMask opens = (v < 0.0) & (stress.p <= floor_pressure(start));
  const LaneMask closes = (v > 0.0) & (gap > 0.0);
  const Lanes in_gap = choose(opens, v, choose(closes, smaller(gap, v), Lanes{}));
  gap -= in_gap;
  return {v - in_gap, strain.e};
}

/// Keeps the pressure at or above its floor and, while there is a gap, at the floor.
/// @param stiffness  K + G/3, Pa: turns pressure into the volumetric strain it stands for
inline void hold_floor(const Initials& start, Stresses& stress, Lanes& gap, const Lanes& stiffness) {
  const Lanes floor = floor_pressure(start);
  const LaneMask free = (stress.p >= floor) & (gap == 0.0);
  if (!any(~free))
    return;
  const Lanes opening = gap + (floor - stress.p) / stiffness;
  gap = choose(free, gap, positive(opening));
  stress.p = choose(free, stress.p, choose(opening >= 0.0, floor, floor - opening * stiffness));
}

} // namespace tremolo::materials::pm4
