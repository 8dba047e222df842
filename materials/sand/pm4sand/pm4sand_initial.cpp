#include "materials/sand/pm4sand/pm4sand_initial.hpp"

#include "materials/sand/pm4sand/pm4sand_surfaces.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials::pm4 {
namespace {

double default_A_do(const Pm4Sand& law, const Surfaces& surface) {
  constexpr double loose = 1.24;
  constexpr double steep = 1.5; // where M_b has no angle
  if (surface.xi_R > 0.0 || surface.M_b - surface.M_d < 1e-9)
    return loose;
  if (surface.M_b > 2.0)
    return steep;
  return 2.5 * (std::asin(0.5 * surface.M_b) - std::asin(0.5 * law.M)) / (surface.M_b - surface.M_d);
}

double default_z_max(const Surfaces& surface) {
  return std::min(0.7 * std::exp(-6.1 * surface.xi_R), 20.0);
}

} // namespace

State initial_state(const Pm4Sand& law, const Stress& stress) {
  State state;
  Initial& start = state.start;
  start.p_min = std::max(stress.p / 200.0, least_pressure(law));
  const double p = std::max(stress.p, start.p_min);
  const Surfaces surface = surfaces(law, p, 0.0);
  start.z_max = law.z_max.value_or(default_z_max(surface));
  start.A_do = law.A_do.value_or(default_A_do(law, surface));
  state.now.z_peak = 1e-5 * start.z_max;
  state.memory.p_zp = 0.01 * p;

  Stress held = stress;
  Deviator& alpha = state.now.alpha;
  if (stress.p < start.p_min) {
    held = {start.p_min, {}};
  } else {
    alpha = (1.0 / p) * stress.s;
    const double M_cur = std::sqrt(stress_ratio2(stress));
    const double M_cut = std::max(surface.M_b, surface.M_d);
    if (M_cur > M_cut) {
      held.s = (M_cut / M_cur) * stress.s;
      alpha = ((M_cut - law.m) / (M_cut * p)) * held.s;
    }
  }
  start.offset = {stress.p - held.p, stress.s - held.s};
  state.memory.alpha_in_true = alpha;
  state.memory.alpha_max = Components::of(alpha);
  state.memory.alpha_min = Components::of(alpha);
  return state;
}

} // namespace tremolo::materials::pm4
