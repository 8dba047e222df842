#include "materials/pm4sand_initial.hpp"

#include "materials/pm4sand_surfaces.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials::pm4 {
namespace {

double default_A_do(const Pm4Sand& law, const Surfaces& surface) {
  constexpr double loose = 1.24;
  constexpr double steep = 1.5; // where M_b has no angle
  if (surface.xi_R > 0.0 || surface.M_b - surface.M_d < 1e-9) {
    return loose;
  }
  if (surface.M_b > 2.0) {
    return steep;
  }
  return 2.5 * (std::asin(0.5 * surface.M_b) - std::asin(0.5 * law.M)) / (surface.M_b - surface.M_d);
}

double default_z_max(const Surfaces& surface) {
  return std::min(0.7 * std::exp(-6.1 * surface.xi_R), 20.0);
}

} // namespace

State initial_state(const Pm4Sand& law, const Stress& stress) {
  State state;
  state.p_min = std::max(stress.p, law.p_A) / 200.0;
  const double p = std::max(stress.p, state.p_min);
  const Surfaces surface = surfaces(law, p, 0.0);
  state.z_max = law.z_max.value_or(default_z_max(surface));
  state.A_do = law.A_do.value_or(default_A_do(law, surface));
  state.z_peak = 1e-5 * state.z_max;
  state.p_zp = 0.01 * p;

  Stress held = stress;
  if (stress.p < state.p_min) {
    held = {state.p_min, {}};
  } else {
    state.alpha = (1.0 / p) * stress.s;
    const double M_cur = stress_ratio(stress.s, p);
    const double M_cut = std::max(surface.M_b, surface.M_d);
    if (M_cur > M_cut) {
      held.s = (M_cut / M_cur) * stress.s;
      state.alpha = ((M_cut - law.m) / (M_cut * p)) * held.s;
    }
  }
  state.offset = {stress.p - held.p, stress.s - held.s};
  state.alpha_in_true = state.alpha;
  state.alpha_max = Components::of(state.alpha);
  state.alpha_min = Components::of(state.alpha);
  return state;
}

} // namespace tremolo::materials::pm4
