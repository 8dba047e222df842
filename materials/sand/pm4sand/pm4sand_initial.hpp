#pragma once

// The start of PM4Sand from a stress: the state at which shaking begins (Boulanger & Ziotopoulou 2017,
// section 3). With xi_R0, M_b, M_d at the initial pressure p_0,
//
//     p_min = max(p_0, p_A)/200,    z_max = min(0.7 exp(-6.1 xi_R0), 20),
//     A_do = 2.5 [asin(M_b/2) - asin(M/2)]/(M_b - M_d) dense of critical (1.5 if M_b > 2), 1.24 loose,
//
// alpha = r. A stress outside the bounding surface is held on it, one with p_0 < p_min at p_min without
// shear; the difference is kept as an offset.

#include "materials/sand/pm4sand/pm4sand_state.hpp"

#include "materials/sand/pm4sand/pm4sand.hpp"

namespace tremolo::materials::pm4 {

/// The least p_min, Pa.
inline double least_pressure(const Pm4Sand& law) {
  return law.p_A / 200.0;
}

/// @param stress  compression positive, Pa
State initial_state(const Pm4Sand& law, const Stress& stress);

} // namespace tremolo::materials::pm4
