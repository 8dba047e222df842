#include "materials/pm4sand_integration.hpp"

#include "materials/pm4sand_low_pressure.hpp"
#include "materials/pm4sand_memory.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials::pm4 {
namespace {

/// The largest component of a strain increment: |eps_xx|, |eps_yy| or |gamma_xy|.
double largest_component(const Strain& strain) {
  return std::max(0.5 * std::abs(strain.volumetric) + std::abs(strain.e.d), 2.0 * std::abs(strain.e.s));
}

/// The part of an elastic change of stress up to the yield surface |s - p alpha| = m p/sqrt2; 0 if it is
/// reached and loading goes on, 1 or more if it is not reached.
double elastic_part(const Pm4Sand& law, const State& state, const Stress& stress, const Stress& elastic) {
  constexpr double reached = 0.99; // of the radius: within 1 per cent of m
  constexpr double never = 2.0;
  const Deviator x = stress.s - stress.p * state.alpha;
  const Deviator dx = elastic.s - elastic.p * state.alpha;
  const double m2 = 0.5 * law.m * law.m;
  const double b = contract(x, dx) - m2 * stress.p * elastic.p;
  const double radius2 = m2 * stress.p * stress.p;
  const double x2 = contract(x, x);
  if (x2 >= reached * reached * radius2 && b >= 0.0) {
    return 0.0;
  }
  const double a = contract(dx, dx) - m2 * elastic.p * elastic.p;
  const double c = std::min(x2 - radius2, 0.0);
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) {
    return never;
  }
  const double root = std::sqrt(discriminant);
  if (b + root > 0.0 && b >= 0.0) {
    return -c / (b + root);
  }
  return a > 0.0 ? (root - b) / a : never;
}

/// The point after a change of its stress and state.
void add(State& state, Stress& stress, const Change& step) {
  stress.p += step.stress.p;
  stress.s = stress.s + step.stress.s;
  state.alpha = state.alpha + step.alpha;
  if (step.z.d != 0.0 || step.z.s != 0.0) {
    state.z = state.z + step.z;
    state.z_cum += norm(step.z) / sqrt2;
    state.z_peak = std::max(state.z_peak, norm(state.z) / sqrt2);
  }
}

Change mean(const Change& a, const Change& b) {
  return {{0.5 * (a.stress.p + b.stress.p), 0.5 * (a.stress.s + b.stress.s)},
          0.5 * (a.alpha + b.alpha),
          0.5 * (a.z + b.z),
          0.5 * (a.plastic_work + b.plastic_work)};
}

/// Relative error of the mean of two changes.
double error_between(const Pm4Sand& law, const State& state, const Stress& stress, const Change& a,
                     const Change& b) {
  const double dp = b.stress.p - a.stress.p;
  const Deviator ds = b.stress.s - a.stress.s;
  const double least = law.p_A / 200.0; // stresses below this need not be known to the same digits
  const double size2 = 2.0 * stress.p * stress.p + contract(stress.s, stress.s);
  const double in_stress = (2.0 * dp * dp + contract(ds, ds)) / std::max(size2, least * least);
  const Deviator dalpha = b.alpha - a.alpha;
  const Deviator dz = b.z - a.z;
  const double in_fabric = contract(dz, dz) / (state.z_max * state.z_max);
  return 0.5 * std::sqrt(std::max({in_stress, contract(dalpha, dalpha), in_fabric}));
}

/// Puts alpha where the stress lies on the yield surface if it lies outside.
void correct_drift(const Pm4Sand& law, State& state, const Stress& stress) {
  const Deviator x = stress.s - stress.p * state.alpha;
  const double radius = law.m * stress.p / sqrt2;
  const double x2 = contract(x, x);
  if (x2 > radius * radius) {
    state.alpha = (1.0 / stress.p) * (stress.s - (radius / std::sqrt(x2)) * x);
  }
}

/// Scales a stress ratio outside the bounding surface back to it.
void hold_bound(const Pm4Sand& law, State& state, Stress& stress, const Surfaces& near) {
  const double M_cur = stress_ratio(stress.s, stress.p);
  if (M_cur < 0.99 * near.M_b) { // the surface hardly moves in a sub-step
    return;
  }
  const double M_b = surfaces(law, std::max(stress.p, state.p_min), state.volumetric_strain).M_b;
  if (M_cur > M_b) {
    stress.s = (M_b / M_cur) * stress.s;
    state.alpha = ((M_b - law.m) / (M_b * stress.p)) * stress.s;
  }
}

/// One attempt at a sub-step.
struct Attempt {
  State state;
  Stress stress;
  double plastic_work = 0.0;
  double part = 1.0;  ///< of the strain that was asked for, up to the yield surface
  double error = 0.0; ///< relative
};

Attempt attempt(const Pm4Sand& law, const State& from, const Stress& stress, const Strain& asked) {
  Attempt result{from, stress};
  State& state = result.state;
  Strain strain = skeleton_strain(state, stress, asked);
  const Site start = site(law, state, stress);
  const Change trial = elastic_change(start, strain);
  const Deviator heading =
      stress.s + trial.stress.s - std::max(stress.p + trial.stress.p, floor_pressure(state)) * state.alpha;
  if (contract(state.alpha - state.alpha_in_true, heading) < 0.0) {
    remember_reversal(state, heading, start.p);
  }

  const double elastic = elastic_part(law, state, stress, trial.stress);
  const bool plastic = elastic == 0.0;
  const Deviator x = stress.s - stress.p * state.alpha;
  const Deviator n = plastic ? (1.0 / norm(x)) * x : Deviator{};
  if (!plastic && elastic < 1.0) {
    result.part = elastic;
    state.gap = from.gap;
    strain = skeleton_strain(state, stress, elastic * asked);
  }
  const Change first = plastic ? change(law, state, start, n, strain) : elastic_change(start, strain);

  State ahead = state;
  Stress there = stress;
  add(ahead, there, first);
  ahead.volumetric_strain += strain.volumetric;
  const Site end = site(law, ahead, there);
  Change second;
  if (plastic) {
    const Deviator y = end.stress.s - end.stress.p * ahead.alpha;
    const double length = norm(y);
    second = change(law, ahead, end, length > 0.0 ? (1.0 / length) * y : n, strain);
  } else {
    second = elastic_change(end, strain);
  }

  const Change step = mean(first, second);
  add(state, result.stress, step);
  state.volumetric_strain += strain.volumetric;
  result.plastic_work = step.plastic_work;
  result.error = error_between(law, state, result.stress, first, second);
  hold_floor(state, result.stress, start.K + start.G / 3.0);
  if (plastic) {
    correct_drift(law, state, result.stress);
  }
  hold_bound(law, state, result.stress, end.surface);
  return result;
}

} // namespace

double integrate(const Pm4Sand& law, State& state, Stress& stress, const Strain& increment) {
  constexpr double safety = 0.9;
  constexpr double smallest_strain = 1e-9; // a sub-step of this size is taken whatever its error
  const double size = largest_component(increment);
  const double largest = law.integration.largest_strain / size;
  double work = 0.0;
  double done = 0.0;
  double length = std::min(largest, 1.0);
  bool rejected = false;
  while (done < 1.0) {
    const bool last = done + length * (1.0 + 1e-9) >= 1.0;
    const double taken = last ? 1.0 - done : length;
    const Attempt next = attempt(law, state, stress, taken * increment);
    const double wanted = safety * std::sqrt(law.integration.tolerance / std::max(next.error, 1e-300));
    if (next.error > law.integration.tolerance && taken * size > smallest_strain) {
      length = taken * std::max(wanted, 0.1);
      rejected = true;
      continue;
    }
    state = next.state;
    stress = next.stress;
    work += next.plastic_work;
    if (next.part < 1.0) {
      done += next.part * taken;
    } else {
      done = last ? 1.0 : done + taken;
      length = std::min(taken * std::min(wanted, rejected ? 1.0 : 2.0), largest);
      length = std::max(length, std::min(smallest_strain / size, largest));
    }
    rejected = false;
  }
  return work;
}

} // namespace tremolo::materials::pm4
