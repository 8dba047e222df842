#include "materials/sand/pm4sand/pm4sand_integration.hpp"

#include "materials/sand/pm4sand/pm4sand_low_pressure.hpp"
#include "materials/sand/pm4sand/pm4sand_memory.hpp"

#include <limits>

namespace tremolo::materials::pm4 {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

LaneMask is_finite(const Lanes& a) {
  return magnitude(a) <= std::numeric_limits<double>::max();
}

/// The largest component of a strain increment: |eps_xx|, |eps_yy| or |gamma_xy|.
Lanes largest_component(const Strains& strain) {
  return larger(2.0 * magnitude(strain.e.s), 0.5 * magnitude(strain.volumetric) + magnitude(strain.e.d));
}

/// The part of an elastic change of stress up to the yield surface |s - p alpha| = m p/sqrt2; 0 if it is
/// reached and loading goes on, 1 or more if it is not reached. A part so small that it would not bring the
/// step nearer to its end is 0.
/// @param x  s - p alpha
Lanes elastic_part(const Sites& at, const Deviators& x, const Stresses& elastic) {
  constexpr double reached = 0.99; // of the radius: within 1 per cent of m
  constexpr double nothing = 1e-9; // rounding, where the stress lies on the surface
  const Lanes never = all(2.0);
  const Lanes p = at.stress.p;
  const Deviators dx = elastic.s - elastic.p * at.now.alpha;
  const double m2 = 0.5 * at.law.m * at.law.m;
  const Lanes b = contract(x, dx) - m2 * p * elastic.p;
  const Lanes radius2 = m2 * p * p;
  const Lanes x2 = contract(x, x);
  const LaneMask loads = (x2 >= reached * reached * radius2) & (b >= 0.0);
  if (!any(~loads))
    return Lanes{};
  const Lanes a = contract(dx, dx) - m2 * elastic.p * elastic.p;
  const Lanes c = smaller(Lanes{}, x2 - radius2);
  const Lanes discriminant = b * b - a * c;
  const Lanes root = sqrt(discriminant);
  const Lanes inward = choose(a > 0.0, (root - b) / a, never);
  const Lanes part = choose(b > 0.0, -c / (b + root), inward);
  return choose(loads | (part < nothing), Lanes{}, choose(discriminant < 0.0, never, part));
}

/// The motion after a change of it.
Motions after(const Motions& now, const Changes& step, const Lanes& volumetric_strain) {
  Motions next = now;
  next.alpha = now.alpha + step.alpha;
  next.volumetric_strain += volumetric_strain;
  const LaneMask changes = (step.z.d != 0.0) | (step.z.s != 0.0);
  if (any(changes)) {
    next.z = now.z + step.z;
    next.z_cum += norm(step.z) / sqrt2;
    next.z_peak = choose(changes, larger(norm(next.z) / sqrt2, now.z_peak), now.z_peak);
  }
  return next;
}

Stresses after(const Stresses& stress, const Changes& step) {
  return {stress.p + step.stress.p, stress.s + step.stress.s};
}

Changes mean(const Changes& a, const Changes& b) {
  return {{0.5 * (a.stress.p + b.stress.p), 0.5 * (a.stress.s + b.stress.s)},
          0.5 * (a.alpha + b.alpha),
          0.5 * (a.z + b.z),
          0.5 * (a.plastic_work + b.plastic_work)};
}

/// Square of the relative error of the mean of two changes; not a number where that of the stress is not.
Lanes error2_between(const Sites& at, const Changes& a, const Changes& b) {
  const Lanes dp = b.stress.p - a.stress.p;
  const Deviators ds = b.stress.s - a.stress.s;
  const double least = at.law.p_A / 200.0; // stresses below this need not be known to the same digits
  const Lanes size2 = 2.0 * at.stress.p * at.stress.p + contract(at.stress.s, at.stress.s);
  const Lanes in_stress = (2.0 * dp * dp + contract(ds, ds)) / larger(all(least * least), size2);
  const Deviators dalpha = b.alpha - a.alpha;
  const Deviators dz = b.z - a.z;
  const Lanes in_fabric = contract(dz, dz) / (at.start.z_max * at.start.z_max);
  return 0.25 * larger(in_fabric, larger(contract(dalpha, dalpha), in_stress));
}

/// Distance of a stress outside the yield surface, Pa.
Lanes outside_yield(const Pm4Sand& law, const Deviators& alpha, const Stresses& stress) {
  return norm(stress.s - stress.p * alpha) - law.m * stress.p / sqrt2;
}

/// Puts alpha where the stress lies on the yield surface if it lies outside.
/// @param drifts  the points to look at
void correct_drift(const Pm4Sand& law, Motions& now, const Stresses& stress, const LaneMask& drifts) {
  const Deviators x = stress.s - stress.p * now.alpha;
  const Lanes radius = law.m * stress.p / sqrt2;
  const Lanes x2 = contract(x, x);
  const LaneMask outside = drifts & (x2 > radius * radius);
  if (any(outside))
    now.alpha = choose(outside, (1.0 / stress.p) * (stress.s - (radius / sqrt(x2)) * x), now.alpha);
}

/// M_b of the present pressure and density.
Lanes bound_of(const Pm4Sand& law, const Initials& start, const Motions& now, const Stresses& stress) {
  return surfaces(law, larger(start.p_min, stress.p), now.volumetric_strain).M_b;
}

/// Brings stresses outside the bounding surface |s| = M_b p/sqrt2 back to it: what is drift from the yield
/// surface, which alpha can no longer follow, along the normal; what the surface itself has shrunk, at
/// constant p. Soil that is pulled apart keeps its pressure.
/// @param outside  the points to bring back
void return_to_bound(const Pm4Sand& law, const Initials& start, Motions& now, Stresses& stress, Lanes M_b,
                     const LaneMask& outside) {
  const Lanes length = norm(stress.s);
  const LaneMask together = now.gap == 0.0;
  Stresses held = stress;
  if (any(outside & together)) {
    const Lanes slope = M_b / sqrt2;
    const Lanes drift = positive(outside_yield(law, now.alpha, stress));
    const Lanes along_normal = smaller(length - slope * stress.p, drift);
    const Lanes shift = 0.5 * slope * along_normal / (1.0 + 0.5 * slope * slope);
    held.p = choose(together, stress.p + shift, stress.p);
    M_b = choose(together, bound_of(law, start, now, held), M_b);
  }
  held.s = (M_b / sqrt2 * held.p / length) * stress.s;
  now.alpha = choose(outside, ((M_b - law.m) / (M_b * held.p)) * held.s, now.alpha);
  stress = choose(outside, held, stress);
}

/// Takes out what has drifted off the yield surface and what lies outside the bounding surface.
/// @param near  the surfaces close by
void correct(const Pm4Sand& law, const Initials& start, Motions& now, Stresses& stress,
             const SurfacesOf<Lanes>& near) {
  constexpr double moves = 0.99; // the bounding surface moves by less in a sub-step
  const Lanes M_cur2 = stress_ratio2(stress);
  LaneMask outside = M_cur2 >= moves * moves * near.M_b * near.M_b;
  if (any(outside)) {
    const Lanes M_b = bound_of(law, start, now, stress);
    outside &= M_cur2 > M_b * M_b;
    if (any(outside))
      return_to_bound(law, start, now, stress, M_b, outside);
  }
  correct_drift(law, now, stress, ~outside);
}

/// One attempt at a sub-step.
struct Attempt {
  Motions now;
  Stresses stress;
  Lanes plastic_work;
  Lanes part;          ///< of the strain that was asked for: up to the yield surface, where that is reached
  Lanes error2;        ///< square of the relative error
  Lanes shear_modulus; ///< at the start, Pa
  LaneMask reverses;   ///< where the memory changes, to:
  Memories memory;
};

/// The memories after the reversals of some points, one by one: reversals are rare.
void remember_reversals(Attempt& result, const States& from, const Deviators& heading, const Lanes& p) {
  result.memory = from.memory;
  const Motions& now = from.now;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    if (result.reverses[lane] == 0)
      continue;
    Memory memory = memory_of(from.memory, lane);
    remember_reversal(memory,
                      {.alpha = {now.alpha.d[lane], now.alpha.s[lane]}, .z = {now.z.d[lane], now.z.s[lane]}},
                      {heading.d[lane], heading.s[lane]}, p[lane]);
    set_memory(memory, lane, result.memory);
  }
}

void attempt(const Pm4Sand& law, const States& from, const Stresses& stress, const Strains& asked,
             Attempt& result) {
  const Initials& start = from.start;
  Lanes gap = from.now.gap;
  Strains strain = skeleton_strain(start, stress, asked, gap);
  Sites first = site(law, start, from.memory, from.now, stress);
  result.shear_modulus = first.G;
  const Changes trial = elastic_change(first, strain);
  const Lanes trial_p = larger(floor_pressure(start), stress.p + trial.stress.p);
  const Deviators heading = stress.s + trial.stress.s - trial_p * from.now.alpha;
  result.reverses = contract(from.now.alpha - from.memory.alpha_in_true, heading) < 0.0;
  if (any(result.reverses)) {
    remember_reversals(result, from, heading, first.p);
    first.memory = &result.memory;
  }

  const Deviators x = first.stress.s - first.stress.p * from.now.alpha;
  const Lanes elastic = elastic_part(first, x, trial.stress);
  const LaneMask plastic = elastic == 0.0;
  result.part = choose(plastic, all(1.0), smaller(all(1.0), elastic));
  if (any(result.part < 1.0)) {
    gap = from.now.gap;
    strain = skeleton_strain(start, stress, result.part * asked, gap);
  }
  const Deviators n = choose(plastic, (1.0 / norm(x)) * x, {});
  const Changes one = change(first, n, strain);

  Motions ahead = after(from.now, one, strain.volumetric);
  Stresses stress_ahead = after(stress, one);
  stress_ahead.p = larger(floor_pressure(start), stress_ahead.p);
  correct(law, start, ahead, stress_ahead, first.surface);
  const Sites second = site(law, start, *first.memory, ahead, stress_ahead);
  const Deviators elastic_s = (2.0 * second.G) * strain.e;
  const Deviators y = stress.s + 0.5 * (one.stress.s + elastic_s) - stress_ahead.p * ahead.alpha;
  const Lanes length = norm(y);
  const Deviators n_ahead = choose(plastic, choose(length > 0.0, (1.0 / length) * y, n), {});
  const Changes two = change(second, n_ahead, strain);

  const Changes step = mean(one, two);
  result.now = after(from.now, step, strain.volumetric);
  result.stress = after(stress, step);
  result.plastic_work = step.plastic_work;
  result.error2 = error2_between(first, one, two);
  hold_floor(start, result.stress, gap, first.K + first.G / 3.0);
  result.now.gap = gap;
  correct(law, start, result.now, result.stress, second.surface);
}

} // namespace

Integrated integrate(const Pm4Sand& law, States& states, Stresses& stress, const Strains& increment,
                     const LaneMask& strained) {
  constexpr double safety = 0.9;
  const Lanes one = all(1.0);
  const Lanes size = largest_component(increment);
  const Lanes largest = law.integration.largest_strain / size;
  // When loading slides along the bounding surface, the plastic modulus has no smallest scale.
  const Lanes smallest = law.integration.smallest_strain / size;
  const double tolerance2 = law.integration.tolerance * law.integration.tolerance;
  Integrated result;
  Lanes& work = result.plastic_work;
  Lanes done{};
  Lanes length = smaller(largest, one);
  LaneMask rejected{};
  LaneMask going = strained;
  Attempt next;
  if (!any(going))
    result.shear_modulus = site(law, states.start, states.memory, states.now, stress).G;
  while (any(going)) {
    const LaneMask last = done + length * (1.0 + 1e-9) >= 1.0;
    const Lanes taken = choose(last, 1.0 - done, length);
    attempt(law, states, stress, taken * increment, next);
    if (result.attempts++ == 0)
      result.shear_modulus = next.shear_modulus;
    const LaneMask finite = is_finite(next.error2) & is_finite(next.plastic_work);
    const LaneMask refused = ~(finite & (next.error2 <= tolerance2)) & (taken > smallest);
    const Lanes fitting = safety * sqrt(sqrt(tolerance2 / larger(all(1e-300), next.error2)));
    const LaneMask accepted = going & finite & ~refused;
    const LaneMask lost = going & ~finite & ~refused;
    work = choose(lost, all(not_a_number), work);
    states.now = choose(accepted, next.now, states.now);
    if (const LaneMask reverses = accepted & next.reverses; any(reverses))
      for (std::size_t lane = 0; lane < 4; ++lane)
        if (reverses[lane] != 0)
          set_memory(memory_of(next.memory, lane), lane, states.memory);
    stress = choose(accepted, next.stress, stress);
    work = choose(accepted, work + next.plastic_work, work);

    const LaneMask whole = next.part == 1.0;
    const LaneMask ends = whole & last;
    done = choose(accepted, choose(ends, one, done + next.part * taken), done);
    const Lanes grown = taken * smaller(choose(rejected, one, all(2.0)), fitting);
    const Lanes shrunk = taken * larger(all(0.1), choose(finite, fitting, Lanes{}));
    const Lanes limited = smaller(largest, larger(smallest, grown));
    length = choose(refused, shrunk, choose(accepted & whole, limited, length));
    rejected = refused;
    going &= ~lost & (done < 1.0);
  }
  return result;
}

} // namespace tremolo::materials::pm4
