// The elastic stiffness that a law names is the one with which it answers a small step back: the stress then
// leaves the yield surface inwards, and what it changes by is elastic.

#include "materials/law/driver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tremolo::materials::test {
namespace {

double ratio_of(const Law& law, const PointTest& point) {
  PointStress s = point.stress();
  std::vector<double> state = point.state();
  Points points;
  points.count = 1;
  points.sxx = &s.xx;
  points.syy = &s.yy;
  points.szz = &s.zz;
  points.sxy = &s.xy;
  points.state = state.data();
  double ratio = 0.0;
  stiffness_ratios(law, points, &ratio);
  return ratio;
}

/// G over that of elasticity(law) by which the stress changes in a step back.
double measured_ratio(const Law& law, PointTest point, double direction) {
  constexpr double step = 1e-9;
  const double before = point.stress().xy;
  point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(-direction * step)});
  return (before - point.stress().xy) / (direction * step) / elasticity(law).shear_modulus();
}

/// Undrained cycles of 0.5 %, until the sand has liquefied: pressure falls, and PM4Sand's fabric grows. The
/// soil turns on the way, beside a stress that its surfaces cannot hold.
void compare(const Law& law, const PointStress& initial, double tolerance) {
  PointTest point(law, initial);
  double least = ratio_of(law, point);
  for (int k = 0; k < 4000; ++k) {
    const double direction = k / 500 % 2 == 0 ? 1.0 : -1.0;
    point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(direction * 1e-5), 1e-4});
    if (k % 50 == 49) {
      const double ratio = ratio_of(law, point);
      ASSERT_NEAR(measured_ratio(law, point, direction) / ratio, 1.0, tolerance) << name(law) << ", " << k;
      least = std::min(least, ratio);
    }
  }
  EXPECT_LT(least, 0.5);
}

TEST(StiffnessRatio, IsThatOfAStepBack) {
  for (const double density : {0.35, 0.55, 0.75}) {
    const Law sand = pm4sand({.density = 1950.0, .relative_density = density, .G_o = 677.0, .h_po = 0.4});
    compare(sand, {-50e3, -100e3, -50e3, 0.0}, 1e-4);
    compare(sand, {-10e3, -100e3, -10e3, 20e3}, 1e-4);
    compare(after_shaking(sand), {-50e3, -100e3, -50e3, 0.0}, 1e-4);
  }
  compare(pdmy03({.relative_density = 0.33}), {-50e3, -100e3, -50e3, 0.0}, 1e-3);
}

TEST(StiffnessRatio, IsOneWhereNothingChangesTheStiffness) {
  const Law clay = LinearElastic{{1900.0, 60e6, 0.3}};
  EXPECT_EQ(ratio_of(clay, PointTest(clay, {-50e3, -100e3, -50e3, 0.0})), 1.0);
}

} // namespace
} // namespace tremolo::materials::test
