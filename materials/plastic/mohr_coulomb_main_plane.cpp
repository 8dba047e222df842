#include "materials/plastic/mohr_coulomb_main_plane.hpp"

#include "materials/law/plastic_work.hpp"
#include "materials/plastic/mohr_coulomb_softening.hpp"
#include "materials/tensor/independent_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::materials {
namespace {

/// One evaluation of h(e + x) = k f/a and its derivative, that of a and k left out.
struct MainPlane {
  double multiplier; ///< lambda
  double step;       ///< h
  double slope;      ///< h'
};

[[gnu::always_inline]] inline MainPlane main_plane(const FadingStrength& strength, double shear, double bulk,
                                                   double s1, double s3) {
  const double sine = strength.now.sin_friction;
  const double flow = strength.now.sin_dilation;
  const double softness = 1.0 / (4.0 * shear * (1.0 + sine * flow / 3.0) + 4.0 * bulk * sine * flow);
  const double k = 2.0 * std::numbers::inv_sqrt3 * std::sqrt(1.0 + flow * flow / 3.0);
  const double f = yield_function(s1, s3, strength.now);
  const double positive = 0.5 * (f + std::abs(f)); // a maximum would become a branch
  const double rate = (s1 + s3) * strength.sin_friction_rate - strength.cohesive_rate;
  return {positive * softness, k * positive * softness, k * rate * softness};
}

/// 1/(1 - h') for the small h' of soil: four terms of its series, which stay finite for any.
[[gnu::always_inline]] inline double newton(double slope) {
  return 1.0 + slope * (1.0 + slope * (1.0 + slope));
}

/// A change of eta e that is slight: what is linear in it is right to its square, 1e-14.
constexpr double slight = 1e-7;

/// The strength after another slight step of plastic strain, its limit in tension aside.
[[gnu::always_inline]] inline FadingStrength continued(FadingStrength strength, double step) {
  strength.now.cohesive += step * strength.cohesive_rate;
  strength.now.sin_friction += step * strength.sin_friction_rate;
  strength.now.sin_dilation += step * strength.sin_dilation_rate;
  return strength;
}

using Lane = PlasticPoints::Lane;

/// In-plane principal stresses: mean + radius and mean - radius.
struct Circle {
  double mean;
  double half; ///< (s_xx - s_yy)/2
  double radius;
};

[[gnu::always_inline]] inline Circle circle(const PlasticPoints& points, std::size_t i) {
  const double half = 0.5 * (points.sxx[i] - points.syy[i]);
  return {0.5 * (points.sxx[i] + points.syy[i]), half,
          std::sqrt(half * half + points.sxy[i] * points.sxy[i])};
}

/// Corrections of the principal stresses by the main plane, Pa, and of the plastic strain. A second loop
/// selects them by factors of 1 or 0: a selection in the first loop would become a branch.
struct Drop {
  Lane first, second, third, plastic_strain;
  Lane softened;          ///< before: the plastic strain, or one at which nothing is left to soften
  Lane taken;             ///< 1 if the point ends on the main plane
  Lane zz_first, zz_last; ///< 1 if s_zz is the largest, the smallest stress
};

template <bool softens, bool fading_dilation>
void find(const MohrCoulomb law, PlasticPoints& points, Drop& drop) { // a copy: nothing stored can change it
  const double shear = law.elastic.shear_modulus();
  const double bulk = law.elastic.bulk_modulus();
  const double limit = cutoff(law);
  const FadingStrength peak = strength_at(law, 0.0);
  const double negligible = softens ? 1e-13 / law.softening : 0.0;
  const std::size_t count = points.count;
  if constexpr (softens) {
    const double all = 690.0 / law.softening; // its exponential is 1e-300
    for (std::size_t i = 0; i < count; ++i)
      drop.softened[i] = std::min(points.plastic_strain[i], all);
  }
  TREMOLO_INDEPENDENT_LOOP
  for (std::size_t i = 0; i < count; ++i) {
    const double e = drop.softened[i];
    const double zz = points.szz[i];
    const Circle in_plane = circle(points, i);
    const double larger = in_plane.mean + in_plane.radius;
    const double smaller = in_plane.mean - in_plane.radius;
    const double s1 = std::max(larger, zz);
    const double s3 = std::min(smaller, zz);
    const double s2 = (larger + smaller + zz) - (s1 + s3); // for the order alone

    FadingStrength strength =
        softens ? strength_after<fading_dilation>(law, limit, elementary::exp(-law.softening * e)) : peak;
    const double tension = strength.now.tension;
    MainPlane plane = main_plane(strength, shear, bulk, s1, s3);
    const double f = plane.multiplier;
    double x = plane.step;
    double gap = 0.0;
    double last = 0.0; // step of Newton's method
    if constexpr (softens) {
      x *= newton(plane.slope);
      strength = strength_after<fading_dilation>(law, limit, elementary::exp(-law.softening * (e + x)));
      plane = main_plane(strength, shear, bulk, s1, s3);
      last = (plane.step - x) * newton(plane.slope);
      x += last;
      strength = continued(strength, last);
      plane = main_plane(strength, shear, bulk, s1, s3);
      gap = std::abs(plane.step - x) - 1e-12 * x;
    }
    const double flow = strength.now.sin_dilation;
    const double pressure = (2.0 * bulk - 4.0 / 3.0 * shear) * flow; // lambda tr(b)
    const double d1 = plane.multiplier * (2.0 * shear * (1.0 + flow) + pressure);
    const double d2 = plane.multiplier * pressure;
    const double d3 = plane.multiplier * (2.0 * shear * (flow - 1.0) + pressure);
    const bool yields = f > 0.0;
    const bool fits = (s1 - d1 >= s2 - d2) & (s2 - d2 >= s3 - d3) &
                      (s1 - d1 <= (1.0 - 10.0 * slight) * strength.now.tension) & (gap <= negligible) &
                      (law.softening * std::abs(last) <= slight);
    drop.first[i] = d1;
    drop.second[i] = d2;
    drop.third[i] = d3;
    drop.plastic_strain[i] = plane.step;
    drop.taken[i] = yields & fits ? 1.0 : 0.0;
    drop.zz_first[i] = zz > larger ? 1.0 : 0.0;
    drop.zz_last[i] = zz < smaller ? 1.0 : 0.0;
    points.left[i] = (yields | (s1 > tension)) & !(yields & fits) ? 1.0 : 0.0;
  }
}

void apply(const Elasticity elastic, PlasticPoints& points, const Drop& drop) {
  const std::size_t count = points.count;
  TREMOLO_INDEPENDENT_LOOP
  for (std::size_t i = 0; i < count; ++i) {
    const Circle in_plane = circle(points, i);
    const double d1 = drop.taken[i] * drop.first[i];
    const double d2 = drop.taken[i] * drop.second[i];
    const double d3 = drop.taken[i] * drop.third[i];
    const double larger = d1 + drop.zz_first[i] * (d2 - d1);
    const double smaller = d3 + drop.zz_last[i] * (d2 - d3);
    const double mean = 0.5 * (larger + smaller);
    const double share = 0.5 * (larger - smaller) / std::max(in_plane.radius, 1e-300);
    const Stress trial = {points.sxx[i], points.syy[i], points.szz[i], points.sxy[i]};
    const Stress relaxed = {mean + share * in_plane.half, mean - share * in_plane.half,
                            d2 + drop.zz_first[i] * (d1 - d2) + drop.zz_last[i] * (d3 - d2),
                            share * trial.xy};
    const StrainIncrement de = {points.dexx[i], points.deyy[i], points.dezz[i], points.dgxy[i]};
    points.plastic_work[i] = plastic_work(elastic, de, trial, relaxed);
    points.sxx[i] = trial.xx - relaxed.xx;
    points.syy[i] = trial.yy - relaxed.yy;
    points.szz[i] = trial.zz - relaxed.zz;
    points.sxy[i] = trial.xy - relaxed.xy;
    points.plastic_strain[i] += drop.taken[i] * drop.plastic_strain[i];
  }
}

} // namespace

void return_to_main_plane(const MohrCoulomb& law, PlasticPoints& points) {
  // Whole vectors only: the last few points would otherwise be rounded as scalars are, and a point's bits
  // would depend on its place.
  constexpr std::size_t vector = 4;
  const std::size_t count = points.count;
  for (; points.count % vector != 0; ++points.count)
    for (Lane* lane : {&points.sxx, &points.syy, &points.szz, &points.sxy, &points.plastic_strain,
                       &points.dexx, &points.deyy, &points.dezz, &points.dgxy})
      (*lane)[points.count] = (*lane)[0];
  Drop drop;
  if (law.softening == 0.0)
    find<false, false>(law, points, drop);
  else if (law.dilation_peak == law.dilation_residual)
    find<true, false>(law, points, drop);
  else
    find<true, true>(law, points, drop);
  apply(law.elastic, points, drop);
  points.count = count;
}

} // namespace tremolo::materials
