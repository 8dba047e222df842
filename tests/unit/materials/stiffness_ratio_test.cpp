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

/// Six points on their way to liquefaction, of which one rests, one turns and one is pulled apart.
void compare_with_update(const Law& law, double tolerance) {
  constexpr std::size_t count = 6;
  const std::size_t size = state_variables(law).size();
  std::vector<double> sxx(count, -50e3), syy(count, -100e3), szz(count, -50e3), sxy(count, 10e3);
  std::vector<double> state(count * size), exx(count), eyy(count), gxy(count), wxy(count), work(count);
  const Points points{count,       sxx.data(), syy.data(), szz.data(), sxy.data(), state.data(),
                      work.data(), exx.data(), eyy.data(), gxy.data(), wxy.data()};
  initialise(law, points);
  std::vector<double> before(count), found(count);
  for (int k = 0; k < 3000; ++k) {
    for (std::size_t i = 1; i < count; ++i)
      gxy[i] = (k / 500 % 2 == 0 ? 1e-5 : -1e-5) * static_cast<double>(i);
    wxy[2] = 1e-4;
    exx[3] = k < 50 ? 1e-5 : 0.0;
    stiffness_ratios(law, points, before.data());
    update_and_find_stiffness(law, points, found.data());
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_NEAR(found[i], before[i], tolerance * before[i])
          << name(law) << ", step " << k << ", point " << i;
  }
  EXPECT_LT(std::ranges::min(before), 0.5 * before.front());
}

TEST(StiffnessRatio, IsGivenByAnUpdateForItsStart) {
  const Law sand = pm4sand({.density = 1950.0, .relative_density = 0.45, .G_o = 677.0, .h_po = 0.4});
  compare_with_update(sand, 1e-9); // rounding: stresses are turned before
  compare_with_update(after_shaking(sand), 1e-9);
  compare_with_update(pdmy03({.relative_density = 0.33}), 0.0);
}

/// Four points of which none is strained have no sub-step to take it from.
TEST(StiffnessRatio, IsGivenForPointsAtRestToo) {
  const Law sand = pm4sand({.density = 1950.0, .relative_density = 0.45, .G_o = 677.0, .h_po = 0.4});
  double sxx = -50e3, syy = -100e3, szz = -50e3, sxy = 0.0, none = 0.0, work = 0.0;
  std::vector<double> state(state_variables(sand).size());
  const Points points{1, &sxx, &syy, &szz, &sxy, state.data(), &work, &none, &none, &none, &none};
  initialise(sand, points);
  double ratio = 0.0, found = 0.0;
  stiffness_ratios(sand, points, &ratio);
  update_and_find_stiffness(sand, points, &found);
  EXPECT_NEAR(found, ratio, 1e-12 * ratio);
  EXPECT_GT(ratio, 0.0);
}

TEST(StiffnessRatio, IsOneWhereNothingChangesTheStiffness) {
  const Law clay = LinearElastic{{1900.0, 60e6, 0.3}};
  EXPECT_EQ(ratio_of(clay, PointTest(clay, {-50e3, -100e3, -50e3, 0.0})), 1.0);
}

} // namespace
} // namespace tremolo::materials::test
