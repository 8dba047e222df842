#include "materials/plastic/mohr_coulomb_softening.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::materials {
namespace {

/// Equivalent deviatoric strain sqrt(2/3 de:de) of the plastic step that took `trial` to `s`.
double plastic_step(const Principal& trial, const Principal& s, double shear_modulus) {
  const Principal d = {trial[0] - s[0], trial[1] - s[1], trial[2] - s[2]};
  const double mean = (d[0] + d[1] + d[2]) / 3.0;
  const double squares =
      (d[0] - mean) * (d[0] - mean) + (d[1] - mean) * (d[1] - mean) + (d[2] - mean) * (d[2] - mean);
  return std::sqrt(2.0 / 3.0 * squares) / (2.0 * shear_modulus);
}

/// Newton's first step for x = h(e + x). On the main plane h = f k with a constant k, so that h' = h f'/f, f'
/// the derivative of f at the trial stress; elsewhere it is a guess.
double first_guess(const Principal& trial, const FadingStrength& start, double step) {
  const double f = yield_function(trial[0], trial[2], start.now);
  const double rate = (trial[0] + trial[2]) * start.sin_friction_rate - start.cohesive_rate;
  const double x = step * f / (f - step * rate);
  return x > 0.0 && x < 2.0 * step ? x : step;
}

} // namespace

// The gap h(e + x) - x is positive at 0 and negative for large x; a secant step inside this bracket converges
// at once, because softening per step is weak against the elastic stiffness, and a bisection takes over where
// it leaves the bracket. The strength of the gap that is left, eta times it, is below 1e-13 of the strength.
Return implicit_return(const MohrCoulomb& law, const Principal& trial, double e,
                       const FadingStrength& start) {
  const double shear = law.elastic.shear_modulus();
  Return result;
  result.stress = return_to_surface(trial, start.now, law.elastic);
  double previous = 0.0;
  double gap_previous = plastic_step(trial, result.stress, shear);
  result.plastic_strain = e + gap_previous;
  if (law.softening == 0.0)
    return result;
  const auto gap = [&](double x) {
    result.stress = return_to_surface(trial, strength_at(law, e + x).now, law.elastic);
    const double step = plastic_step(trial, result.stress, shear);
    result.plastic_strain = e + step;
    return step - x;
  };
  const double negligible = 1e-13 / law.softening;
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
  double x = first_guess(trial, start, gap_previous);
  constexpr int most_steps = 200; // bisection alone needs about 60
  for (int step = 0; step < most_steps; ++step) {
    const double gap_x = gap(x);
    if (std::abs(gap_x) <= std::max(negligible, 1e-12 * x))
      break;
    (gap_x > 0.0 ? low : high) = x;
    const double slope = (gap_x - gap_previous) / (x - previous);
    previous = x;
    gap_previous = gap_x;
    x -= gap_x / slope;
    if (!(x > low && x < high))
      x = std::isinf(high) ? 2.0 * previous : 0.5 * (low + high);
    if (x <= low || x >= high) // the bracket has shrunk to neighbouring numbers
      break;
  }
  return result;
}

} // namespace tremolo::materials
