#pragma once

// What must hold of a PDMY03 point after every update.

#include "materials/law/driver.hpp"
#include "materials/sand/pdmy03/pdmy03_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::materials::test {

inline constexpr double densities[] = {0.33, 0.57, 0.74, 0.87};

inline Pdmy03State state_of(const PointTest& point) {
  return load_pdmy03(point.state().data());
}

inline double mean_stress(const PointStress& s) {
  return (s.xx + s.yy + s.zz) / 3.0;
}

/// q = sqrt(3/2 s:s), Pa
inline double shear_measure(const PointStress& s) {
  const double m = mean_stress(s);
  return std::sqrt(1.5 * ((s.xx - m) * (s.xx - m) + (s.yy - m) * (s.yy - m) + (s.zz - m) * (s.zz - m) +
                          2.0 * s.xy * s.xy));
}

/// A number, no tension of the mean, inside the failure cone. Centres at rest are single precision: an
/// elastic core that touches the failure surface may stick out by one part in 10^7 of it.
inline ::testing::AssertionResult held(const Pdmy03& law, const PointStress& s) {
  const double m = mean_stress(s);
  const double q = shear_measure(s);
  const double strength = law.ratio[law.surfaces] * (law.residual_pressure - m);
  if (std::isfinite(q) && m <= 1e-9 && q <= strength * (1.0 + 1e-6)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << "mean stress " << m << " Pa, q " << q << " Pa, strength " << strength << " Pa";
}

inline PointStep sheared(double shear, double volume = 0.0) {
  return {Control::strain(0.5 * volume), Control::strain(0.5 * volume), Control::strain(shear)};
}

} // namespace tremolo::materials::test
