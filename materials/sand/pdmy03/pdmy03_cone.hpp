#pragma once

// Geometry of one yield surface, seen in the deviatoric plane at a mean stress: a circle about h c of radius
// sqrt(2/3) M H, where H = p' + p_res is the distance from the common apex and h = -H.

#include "materials/tensor/deviator3.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {

/// A yield surface: slope M, centre c.
struct YieldCone {
  double ratio = 0.0;
  Deviator3 centre;

  /// The deviator seen from the axis of the cone, s - h c.
  Deviator3 from_axis(const Deviator3& s, double height) const { return s + height * centre; }

  double radius(double height) const { return std::sqrt(2.0 / 3.0) * ratio * height; }

  /// f, Pa2: negative inside.
  double yield_function(const Deviator3& s, double height) const {
    const Deviator3 t = from_axis(s, height);
    return 1.5 * dot(t, t) - ratio * height * ratio * height;
  }

  /// The stress scaled along its distance from the axis until it is on the cone.
  Deviator3 projected(const Deviator3& s, double height) const {
    const Deviator3 t = from_axis(s, height);
    const double distance = norm(t);
    return distance > 0.0 ? (radius(height) / distance) * t - height * centre : s;
  }

  /// The unit normal at a stress, as a full tensor of norm one.
  MeanAndDeviator normal(const Deviator3& s, double height) const {
    const Deviator3 deviator = 3.0 * from_axis(s, height);
    const double mean = -height * (dot(centre, centre) - 2.0 / 3.0 * ratio * ratio) - dot(s, centre);
    const double squares = dot(deviator, deviator) + 3.0 * mean * mean;
    const double scale = squares > 0.0 ? 1.0 / std::sqrt(squares) : 0.0;
    return {scale * mean, scale * deviator};
  }

  /// The centre of a smaller surface that touches this one from inside at a stress on it.
  Deviator3 centre_inside(const Deviator3& s, double height, double smaller) const {
    return (-1.0 / height) * (s - (smaller / ratio) * from_axis(s, height));
  }
};

/// The centre of `inner` after a stress has reached it and it has been pushed towards the point of `outer`
/// with the same normal, so that surfaces never intersect (Mroz 1967; Prevost 1985): with
/// X >= 1, h c + X t on the outer surface, t = s - h c,
///     mu = (h c + X t)(1 - M/M') - h (c - c' M/M'),    c <- c - X' mu so that s is on it.
inline Deviator3 translated_centre(const YieldCone& inner, const YieldCone& outer, const Deviator3& s,
                                   double height) {
  const Deviator3 t = inner.from_axis(s, height);
  const double radius = inner.radius(height);
  const double distance = norm(t);
  const double excess = distance * distance - radius * radius;
  if (!(excess > 0.0))
    return inner.centre;
  const Deviator3 between = height * (outer.centre - inner.centre); // h (c - c')
  const double outer_radius = outer.radius(height);
  const double tt = distance * distance;
  const double tb = dot(t, between);
  const double inside = dot(between, between) - outer_radius * outer_radius;
  const double x = (-tb + std::sqrt(std::max(0.0, tb * tb - tt * inside))) / tt;
  if (x >= 1.0) {
    const double share = inner.ratio / outer.ratio;
    const Deviator3 mu =
        (1.0 - share) * (x * t - height * inner.centre) + height * (inner.centre - share * outer.centre);
    // |t - H X' mu| = radius
    const double tm = height * dot(t, mu);
    const double mm = height * height * dot(mu, mu);
    const double discriminant = tm * tm - mm * excess;
    if (tm > 0.0 && discriminant >= 0.0)
      return inner.centre - (excess / (tm + std::sqrt(discriminant))) * mu;
  }
  // degenerate: follow the stress itself
  return inner.centre - ((1.0 - radius / distance) / height) * t;
}

} // namespace tremolo::materials
