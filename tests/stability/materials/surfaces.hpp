#pragma once

// The surfaces that stresses must not leave, written down a second time.

#include "materials/law/driver.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {

struct Extremes {
  double largest = 0.0;  ///< s1, Pa
  double smallest = 0.0; ///< s3, Pa
};

inline Extremes principal(const PointStress& s) {
  const double mean = 0.5 * (s.xx + s.yy);
  const double radius = std::hypot(0.5 * (s.xx - s.yy), s.xy);
  return {std::max(mean + radius, s.zz), std::min(mean - radius, s.zz)};
}

/// How far the stress lies outside the Mohr-Coulomb surface of its plastic strain, Pa.
inline double excess(const MohrCoulomb& soil, const PointStress& stress, double e) {
  const double decay = std::exp(-soil.softening * e);
  const double c = soil.cohesion_residual + (soil.cohesion_peak - soil.cohesion_residual) * decay;
  const double phi = soil.friction_residual + (soil.friction_peak - soil.friction_residual) * decay;
  const Extremes s = principal(stress);
  const double shear =
      (s.largest - s.smallest) + (s.largest + s.smallest) * std::sin(phi) - 2.0 * c * std::cos(phi);
  return soil.tension_cutoff ? std::max(shear, s.largest - *soil.tension_cutoff) : shear;
}

/// Work of the stress at the end of a step on the plastic strain of the step, J/m3.
inline double end_work(const Elasticity& elastic, const PointStress& trial, const PointStress& end) {
  const PointStress d = {trial.xx - end.xx, trial.yy - end.yy, trial.zz - end.zz, trial.xy - end.xy};
  const double products = end.xx * d.xx + end.yy * d.yy + end.zz * d.zz + 2.0 * end.xy * d.xy;
  const double traces = (end.xx + end.yy + end.zz) * (d.xx + d.yy + d.zz);
  return ((1.0 + elastic.poisson) * products - elastic.poisson * traces) / elastic.young;
}

/// sqrt(s:s/2), Pa
inline double shear_invariant(const PointStress& s) {
  const double difference_squares =
      (s.xx - s.yy) * (s.xx - s.yy) + (s.yy - s.zz) * (s.yy - s.zz) + (s.zz - s.xx) * (s.zz - s.xx);
  return std::sqrt(difference_squares / 6.0 + s.xy * s.xy);
}

/// How far the stress lies outside the Drucker-Prager cone, Pa.
inline double excess(const DruckerPrager& soil, const PointStress& stress) {
  const Cone c = cone(soil);
  return shear_invariant(stress) + c.slope * (stress.xx + stress.yy + stress.zz) / 3.0 - c.strength;
}

} // namespace tremolo::materials
