#pragma once

// What must hold of PM4Sand after any step: internal stress above its floor and inside the bounding surface,
// back stress within the yield surface of the stress, fabric within its largest.

#include "materials/sand/pm4sand/pm4sand_surfaces.hpp"
#include "materials/tensor/material_axes.hpp"
#include "tests/support/pm4sand_soil.hpp"

#include <gtest/gtest.h>

namespace tremolo::materials::test {

/// The stress that the surfaces hold, in the axes of the material, compression positive.
inline pm4::Stress held_stress(const PointStress& stress, const pm4::State& state) {
  const InPlaneStress turned = MaterialAxes(state.angle).to_material({stress.xx, stress.yy, stress.xy});
  return {-0.5 * (turned.xx + turned.yy) - state.start.offset.p,
          {-0.5 * (turned.xx - turned.yy) - state.start.offset.s.d, -turned.xy - state.start.offset.s.s}};
}

/// Empty if all is well.
inline std::string broken_bound(const Pm4Sand& law, const PointTest& point) {
  const pm4::State state = pm4::load(point.state().data());
  for (const double value : point.state()) {
    if (!std::isfinite(value)) {
      return "a state variable is not finite";
    }
  }
  const pm4::Stress held = held_stress(point.stress(), state);
  if (!(std::isfinite(held.p) && std::isfinite(norm(held.s)) && std::isfinite(point.plastic_work()))) {
    return "stress or plastic work is not finite";
  }
  const double rounding = 1e-9 * (held.p + std::abs(state.start.offset.p) + norm(state.start.offset.s));
  if (held.p < pm4::floor_pressure(state.start) - rounding) {
    return "p is below its floor";
  }
  const double M_b = pm4::surfaces(law, std::max(held.p, state.start.p_min), state.now.volumetric_strain).M_b;
  if (pm4::sqrt2 * norm(held.s) > M_b * held.p + 4.0 * rounding) {
    return "M_cur is above M_b";
  }
  if (norm(held.s - held.p * state.now.alpha) > law.m * held.p / pm4::sqrt2 + 4.0 * rounding) {
    return "the stress is outside the yield surface";
  }
  if (norm(state.now.z) > state.start.z_max * (1.0 + 1e-3) || state.now.z_peak > state.start.z_max ||
      state.now.z_cum < 0.0) {
    return "fabric is outside its bounds";
  }
  return state.now.gap < 0.0 ? "the gap is negative" : "";
}

} // namespace tremolo::materials::test
