#include "materials/sand/pm4sand/pm4sand_integration.hpp"

#include "materials/sand/pm4sand/pm4sand_low_pressure.hpp"
#include "materials/sand/pm4sand/pm4sand_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::materials::pm4 {
namespace {

/// The largest component of a strain increment: |eps_xx|, |eps_yy| or |gamma_xy|.
double largest_component(const Strain& strain) {
  return std::max(0.5 * std::abs(strain.volumetric) + std::abs(strain.e.d), 2.0 * std::abs(strain.e.s));
}

/// The part of an elastic change of stress up to the yield surface |s - p alpha| = m p/sqrt2; 0 if it is
/// reached and loading goes on, 1 or more if it is not reached.
/// @param x  s - p alpha
double elastic_part(const Site& at, Deviator x, const Stress& elastic) {
  constexpr double reached = 0.99; // of the radius: within 1 per cent of m
  constexpr double never = 2.0;
  const double p = at.stress.p;
  const Deviator dx = elastic.s - elastic.p * at.now.alpha;
  const double m2 = 0.5 * at.law.m * at.law.m;
  const double b = contract(x, dx) - m2 * p * elastic.p;
  const double radius2 = m2 * p * p;
  const double x2 = contract(x, x);
  if (x2 >= reached * reached * radius2 && b >= 0.0)
    return 0.0;
  const double a = contract(dx, dx) - m2 * elastic.p * elastic.p;
  const double c = std::min(x2 - radius2, 0.0);
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0)
    return never;
  const double root = std::sqrt(discriminant);
  if (b > 0.0)
    return -c / (b + root);
  return a > 0.0 ? (root - b) / a : never;
}

/// The motion after a change of it.
Motion after(const Motion& now, const Change& step, double volumetric_strain) {
  Motion next = now;
  next.alpha = now.alpha + step.alpha;
  next.volumetric_strain += volumetric_strain;
  if (step.z.d != 0.0 || step.z.s != 0.0) {
    next.z = now.z + step.z;
    next.z_cum += norm(step.z) / sqrt2;
    next.z_peak = std::max(now.z_peak, norm(next.z) / sqrt2);
  }
  return next;
}

Stress after(const Stress& stress, const Change& step) {
  return {stress.p + step.stress.p, stress.s + step.stress.s};
}

Change mean(const Change& a, const Change& b) {
  return {{0.5 * (a.stress.p + b.stress.p), 0.5 * (a.stress.s + b.stress.s)},
          0.5 * (a.alpha + b.alpha),
          0.5 * (a.z + b.z),
          0.5 * (a.plastic_work + b.plastic_work)};
}

/// Square of the relative error of the mean of two changes.
double error2_between(const Site& at, const Change& a, const Change& b) {
  const double dp = b.stress.p - a.stress.p;
  const Deviator ds = b.stress.s - a.stress.s;
  const double least = at.law.p_A / 200.0; // stresses below this need not be known to the same digits
  const double size2 = 2.0 * at.stress.p * at.stress.p + contract(at.stress.s, at.stress.s);
  const double in_stress = (2.0 * dp * dp + contract(ds, ds)) / std::max(size2, least * least);
  const Deviator dalpha = b.alpha - a.alpha;
  const Deviator dz = b.z - a.z;
  const double in_fabric = contract(dz, dz) / (at.start.z_max * at.start.z_max);
  return 0.25 * std::max(std::max(in_stress, contract(dalpha, dalpha)), in_fabric);
}

/// How far a stress lies outside the yield surface, Pa.
double outside_yield(const Pm4Sand& law, Deviator alpha, const Stress& stress) {
  return norm(stress.s - stress.p * alpha) - law.m * stress.p / sqrt2;
}

/// Puts alpha where the stress lies on the yield surface if it lies outside.
void correct_drift(const Pm4Sand& law, Motion& now, const Stress& stress) {
  const Deviator x = stress.s - stress.p * now.alpha;
  const double radius = law.m * stress.p / sqrt2;
  const double x2 = contract(x, x);
  if (x2 > radius * radius)
    now.alpha = (1.0 / stress.p) * (stress.s - (radius / std::sqrt(x2)) * x);
}

/// M_b of the present pressure and density.
double bound_of(const Pm4Sand& law, const Initial& start, const Motion& now, const Stress& stress) {
  return surfaces(law, std::max(stress.p, start.p_min), now.volumetric_strain).M_b;
}

/// Brings a stress outside the bounding surface |s| = M_b p/sqrt2 back to it: what is drift from the yield
/// surface, which alpha can no longer follow, along the normal; what the surface itself has shrunk, at
/// constant p. Soil that is pulled apart keeps its pressure.
void return_to_bound(const Pm4Sand& law, const Initial& start, Motion& now, Stress& stress, double M_b) {
  const double length = norm(stress.s);
  if (now.gap == 0.0) {
    const double slope = M_b / sqrt2;
    const double drift = std::max(outside_yield(law, now.alpha, stress), 0.0);
    const double along_normal = std::min(drift, length - slope * stress.p);
    stress.p += 0.5 * slope * along_normal / (1.0 + 0.5 * slope * slope);
    M_b = bound_of(law, start, now, stress);
  }
  stress.s = (M_b / sqrt2 * stress.p / length) * stress.s;
  now.alpha = ((M_b - law.m) / (M_b * stress.p)) * stress.s;
}

/// Takes out what has drifted off the yield surface and what lies outside the bounding surface.
/// @param near  the surfaces close by
void correct(const Pm4Sand& law, const Initial& start, Motion& now, Stress& stress, const Surfaces& near) {
  constexpr double moves = 0.99; // the bounding surface moves by less in a sub-step
  const double M_cur2 = stress_ratio2(stress);
  if (M_cur2 >= moves * moves * near.M_b * near.M_b) {
    const double M_b = bound_of(law, start, now, stress);
    if (M_cur2 > M_b * M_b) {
      return_to_bound(law, start, now, stress, M_b);
      return;
    }
  }
  correct_drift(law, now, stress);
}

/// One attempt at a sub-step.
struct Attempt {
  Motion now;
  Stress stress;
  double plastic_work = 0.0;
  double part = 1.0;     ///< of the strain that was asked for: up to the yield surface, where that is reached
  double error2 = 0.0;   ///< square of the relative error
  bool reverses = false; ///< the memory has changed, to:
  Memory memory;
};

void attempt(const Pm4Sand& law, const State& from, const Stress& stress, const Strain& asked,
             Attempt& result) {
  const Initial& start = from.start;
  double gap = from.now.gap;
  Strain strain = skeleton_strain(start, stress, asked, gap);
  Site first = site(law, start, from.memory, from.now, stress);
  const Change trial = elastic_change(first, strain);
  const double trial_p = std::max(stress.p + trial.stress.p, floor_pressure(start));
  const Deviator heading = stress.s + trial.stress.s - trial_p * from.now.alpha;
  result.reverses = contract(from.now.alpha - from.memory.alpha_in_true, heading) < 0.0;
  if (result.reverses) {
    result.memory = from.memory;
    remember_reversal(result.memory, from.now, heading, first.p);
    first.memory = &result.memory;
  }

  const Deviator x = first.stress.s - first.stress.p * from.now.alpha;
  const double elastic = elastic_part(first, x, trial.stress);
  const bool plastic = elastic == 0.0;
  result.part = plastic ? 1.0 : std::min(elastic, 1.0);
  if (result.part < 1.0) {
    gap = from.now.gap;
    strain = skeleton_strain(start, stress, result.part * asked, gap);
  }
  const Deviator n = plastic ? (1.0 / norm(x)) * x : Deviator{};
  const Change one = plastic ? change(first, n, strain) : elastic_change(first, strain);

  const Motion ahead = after(from.now, one, strain.volumetric);
  const Site second = site(law, start, *first.memory, ahead, after(stress, one));
  const Deviator y = second.stress.s - second.stress.p * ahead.alpha;
  const double length = norm(y);
  const Deviator n_ahead = length > 0.0 ? (1.0 / length) * y : n;
  const Change two = plastic ? change(second, n_ahead, strain) : elastic_change(second, strain);

  const Change step = mean(one, two);
  result.now = after(from.now, step, strain.volumetric);
  result.stress = after(stress, step);
  result.plastic_work = step.plastic_work;
  result.error2 = error2_between(first, one, two);
  hold_floor(start, result.stress, gap, first.K + first.G / 3.0);
  result.now.gap = gap;
  correct(law, start, result.now, result.stress, second.surface);
}

} // namespace

double integrate(const Pm4Sand& law, State& state, Stress& stress, const Strain& increment) {
  constexpr double safety = 0.9;
  // A sub-step this much smaller than the largest is taken whatever its error: where loading slides along the
  // bounding surface the plastic modulus has no smallest scale.
  constexpr double smallest_part = 0.01;
  const double size = largest_component(increment);
  const double largest = law.integration.largest_strain / size;
  const double smallest = smallest_part * largest;
  const double tolerance2 = law.integration.tolerance * law.integration.tolerance;
  double work = 0.0;
  double done = 0.0;
  double length = std::min(largest, 1.0);
  bool rejected = false;
  Attempt next;
  while (done < 1.0) {
    const bool last = done + length * (1.0 + 1e-9) >= 1.0;
    const double taken = last ? 1.0 - done : length;
    attempt(law, state, stress, taken * increment, next);
    const bool finite = std::isfinite(next.error2) && std::isfinite(next.plastic_work);
    if (!(finite && next.error2 <= tolerance2) && taken > smallest) {
      const double wanted = finite ? safety * std::sqrt(std::sqrt(tolerance2 / next.error2)) : 0.0;
      length = taken * std::max(wanted, 0.1);
      rejected = true;
      continue;
    }
    if (!finite)
      return std::numeric_limits<double>::quiet_NaN();
    state.now = next.now;
    if (next.reverses)
      state.memory = next.memory;
    stress = next.stress;
    work += next.plastic_work;
    if (next.part == 1.0 && last)
      break;
    done += next.part * taken;
    if (next.part == 1.0) {
      const double wanted = safety * std::sqrt(std::sqrt(tolerance2 / std::max(next.error2, 1e-300)));
      length = taken * std::min(wanted, rejected ? 1.0 : 2.0);
      length = std::min(std::max(length, smallest), largest);
    }
    rejected = false;
  }
  return work;
}

} // namespace tremolo::materials::pm4
