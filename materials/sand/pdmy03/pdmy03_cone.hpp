#pragma once

// Geometry of one yield surface, seen in the deviatoric plane at a mean stress: a circle about h c of radius
// sqrt(2/3) M H, where H = p' + p_res is the distance from the common apex and h = -H. Real is double for one
// surface, or Lanes for those of four points.

#include "materials/tensor/deviator3.hpp"

#include <cmath>

namespace tremolo::materials {

/// A yield surface: slope M, centre c.
template <typename Real>
struct YieldConeOf {
  Real ratio{};
  Deviator3Of<Real> centre;

  /// The deviator seen from the axis of the cone, s - h c.
  Deviator3Of<Real> from_axis(const Deviator3Of<Real>& s, const Real& height) const {
    return s + height * centre;
  }

  Real radius(const Real& height) const { return std::sqrt(2.0 / 3.0) * ratio * height; }

  /// f, Pa2: negative inside.
  Real yield_function(const Deviator3Of<Real>& s, const Real& height) const {
    const Deviator3Of<Real> t = from_axis(s, height);
    return 1.5 * dot(t, t) - ratio * height * ratio * height;
  }

  /// The stress scaled along its distance from the axis until it is on the cone.
  Deviator3Of<Real> projected(const Deviator3Of<Real>& s, const Real& height) const {
    const Deviator3Of<Real> t = from_axis(s, height);
    const Real distance = norm(t);
    return choose(distance > 0.0, (radius(height) / distance) * t - height * centre, s);
  }

  /// The unit normal at a stress, as a full tensor of norm one.
  MeanAndDeviatorOf<Real> normal(const Deviator3Of<Real>& s, const Real& height) const {
    const Deviator3Of<Real> deviator = 3.0 * from_axis(s, height);
    const Real mean = -height * (dot(centre, centre) - 2.0 / 3.0 * ratio * ratio) - dot(s, centre);
    const Real squares = dot(deviator, deviator) + 3.0 * mean * mean;
    const Real scale = choose(squares > 0.0, 1.0 / sqrt(squares), Real{});
    return {scale * mean, scale * deviator};
  }

  /// The centre of a smaller surface that touches this one from inside at a stress on it.
  Deviator3Of<Real> centre_inside(const Deviator3Of<Real>& s, const Real& height, const Real& smaller) const {
    return (-1.0 / height) * (s - (smaller / ratio) * from_axis(s, height));
  }
};
using YieldCone = YieldConeOf<double>;
using YieldCones = YieldConeOf<Lanes>;

/// The centres of `inner` after stresses have reached them and they have been pushed towards the points of
/// `outer` with the same normal, so that surfaces never intersect (Mroz 1967; Prevost 1985): with X >= 1,
/// h c + X t on the outer surface, t = s - h c,
///     mu = (h c + X t)(1 - M/M') - h (c - c' M/M'),    c <- c - X' mu so that s is on it.
inline Deviator3Of<Lanes> translated_centre(const YieldCones& inner, const YieldCones& outer,
                                            const Deviator3Of<Lanes>& s, const Lanes& height) {
  const Deviator3Of<Lanes> t = inner.from_axis(s, height);
  const Lanes radius = inner.radius(height);
  const Lanes tt = dot(t, t);
  const Lanes excess = tt - radius * radius;
  const LaneMask outside = excess > 0.0;
  const Deviator3Of<Lanes> between = height * (outer.centre - inner.centre); // h (c - c')
  const Lanes outer_radius = outer.radius(height);
  const Lanes tb = dot(t, between);
  const Lanes inside = dot(between, between) - outer_radius * outer_radius;
  const Lanes x = (sqrt(positive(tb * tb - tt * inside)) - tb) / tt;
  const Lanes share = inner.ratio / outer.ratio;
  const Deviator3Of<Lanes> mu =
      (1.0 - share) * (x * t - height * inner.centre) + height * (inner.centre - share * outer.centre);
  // |t - H X' mu| = radius
  const Lanes tm = height * dot(t, mu);
  const Lanes mm = height * height * dot(mu, mu);
  const Lanes discriminant = tm * tm - mm * excess;
  const LaneMask meets = (x >= 1.0) & (tm > 0.0) & (discriminant >= 0.0);
  Deviator3Of<Lanes> step = (excess / (tm + sqrt(discriminant))) * mu;
  if (any(outside & ~meets)) // degenerate: follow the stress itself
    step = choose(meets, step, ((1.0 - radius / sqrt(tt)) / height) * t);
  return choose(outside, inner.centre - step, inner.centre);
}

} // namespace tremolo::materials
