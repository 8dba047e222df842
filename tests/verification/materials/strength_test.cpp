// Limit stresses of Mohr-Coulomb soil against closed forms (Rankine; Davis 1968 for simple shear with
// dilation).

#include "soils.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo::materials::test {
namespace {

/// Plane-strain compression along y with the lateral stress held; returns the largest and the last -sigma_yy.
struct Compression {
  double peak = 0.0;
  double last = 0.0;
};

Compression compress(const MohrCoulomb& soil, double lateral, double strain, int steps) {
  PointTest point(soil, {-lateral, -lateral, -lateral, 0.0});
  Compression result;
  for (int n = 0; n < steps; ++n) {
    point.apply({Control::stress(-lateral), Control::strain(-strain / steps)});
    result.last = -point.stress().yy;
    result.peak = std::max(result.peak, result.last);
  }
  return result;
}

/// Horizontal stress left after moving the x sides by a given strain under constant vertical stress.
double horizontal_after(const MohrCoulomb& soil, double vertical, double strain, int steps) {
  PointTest point(soil, {-0.5 * vertical, -vertical, -0.5 * vertical, 0.0});
  for (int n = 0; n < steps; ++n) {
    point.apply({Control::strain(strain / steps), Control::stress(-vertical)});
  }
  return -point.stress().xx;
}

/// Simple shear from K0 = 0.5 under constant vertical stress without lateral strain.
PointTest shear_drained(const MohrCoulomb& soil, double vertical, double shear_strain, int steps) {
  PointTest point(soil, {-0.5 * vertical, -vertical, -0.5 * vertical, 0.0});
  for (int n = 0; n < steps; ++n) {
    point.apply({Control::strain(0.0), Control::stress(-vertical), Control::strain(shear_strain / steps)});
  }
  return point;
}

TEST(Compression, PeakAndResidualStressFollowRankine) {
  for (const double lateral : {50.0 * kPa, 100.0 * kPa}) {
    const MohrCoulomb soil = slope_soil();
    const double n_peak = flow_value(soil.friction_peak);
    const double peak = n_peak * lateral + 2.0 * soil.cohesion_peak * std::sqrt(n_peak);
    const double residual = flow_value(soil.friction_residual) * lateral;
    EXPECT_NEAR(compress(without_softening(soil), lateral, 0.1, 100).last, peak, 1e-9 * peak);
    EXPECT_NEAR(compress(residual_soil(), lateral, 0.1, 100).last, residual, 1e-9 * residual);
    // exp(-15 * 2.3) leaves 1e-15 of the drop from peak to residual strength
    EXPECT_NEAR(compress(soil, lateral, 2.0, 20000).last, residual, 1e-9 * residual);
  }
}

TEST(Compression, TableOfValues) {
  EXPECT_NEAR(compress(without_softening(slope_soil()), 50.0 * kPa, 0.1, 100).last, 310.735 * kPa, 1.0);
  EXPECT_NEAR(compress(residual_soil(), 50.0 * kPa, 0.1, 100).last, 138.49 * kPa, 5.0);
  EXPECT_NEAR(compress(without_softening(slope_soil()), 100.0 * kPa, 0.1, 100).last, 602.16 * kPa, 5.0);
  EXPECT_NEAR(compress(residual_soil(), 100.0 * kPa, 0.1, 100).last, 276.98 * kPa, 5.0);
}

TEST(Compression, PeakOfTheSofteningSoilIsReachedInSmallSteps) {
  EXPECT_NEAR(compress(slope_soil(), 50.0 * kPa, 0.01, 100000).peak, 310.735 * kPa, 10.0);
}

TEST(EarthPressure, ActiveAndPassiveStressFollowRankine) {
  const double vertical = 100.0 * kPa;
  for (const MohrCoulomb& soil : {without_softening(slope_soil()), residual_soil()}) {
    const double n = flow_value(soil.friction_peak);
    const double c = soil.cohesion_peak;
    const double active = vertical / n - 2.0 * c / std::sqrt(n);
    const double passive = n * vertical + 2.0 * c * std::sqrt(n);
    EXPECT_NEAR(horizontal_after(soil, vertical, 0.02, 50), active, 1e-9 * vertical);
    EXPECT_NEAR(horizontal_after(soil, vertical, -0.1, 200), passive, 1e-9 * passive);
  }
}

TEST(SimpleShear, FirstYieldUnderConstantVerticalStress) {
  const MohrCoulomb soil = slope_soil();
  const double vertical = 100.0 * kPa;
  const double mean = 0.75 * vertical;
  const double radius =
      mean * std::sin(soil.friction_peak) + soil.cohesion_peak * std::cos(soil.friction_peak);
  const double yield = std::sqrt(radius * radius - 0.0625 * vertical * vertical);
  const double yield_strain = yield / soil.elastic.shear_modulus();
  EXPECT_NEAR(yield, 49.95 * kPa, 5.0);
  EXPECT_EQ(shear_drained(soil, vertical, 0.9999 * yield_strain, 1).state()[equivalent_plastic_strain], 0.0);
  EXPECT_GT(shear_drained(soil, vertical, 1.0001 * yield_strain, 1).state()[equivalent_plastic_strain], 0.0);
}

TEST(SimpleShear, LimitUnderConstantVerticalStress) {
  const double vertical = 100.0 * kPa;
  for (const MohrCoulomb& soil :
       {without_softening(slope_soil()), residual_soil(), perfect_soil(30.0, 10.0, 10.0)}) {
    const double cos_dilation = std::cos(soil.dilation_peak);
    const double limit =
        (vertical * std::sin(soil.friction_peak) + soil.cohesion_peak * std::cos(soil.friction_peak)) *
        cos_dilation / (1.0 - std::sin(soil.friction_peak) * std::sin(soil.dilation_peak));
    const PointTest point = shear_drained(soil, vertical, 0.2, 400);
    EXPECT_NEAR(point.stress().xy, limit, 1e-6 * limit);
  }
  EXPECT_NEAR(shear_drained(without_softening(slope_soil()), vertical, 0.2, 400).stress().xy, 73.539 * kPa,
              1.0);
  EXPECT_NEAR(shear_drained(perfect_soil(30.0, 10.0, 10.0), vertical, 0.2, 400).stress().xy, 53.931 * kPa,
              1.0);
}

TEST(SimpleShear, SofteningSoilComesToItsResidualStrength) {
  const double residual = 100.0 * kPa * std::sin(28.0 * degree);
  EXPECT_NEAR(shear_drained(slope_soil(), 100.0 * kPa, 2.5, 5000).stress().xy, residual, 1e-6 * residual);
}

TEST(SimpleShear, LimitAtConstantVolume) {
  const MohrCoulomb soil = without_softening(slope_soil());
  PointTest point(soil, {-75.0 * kPa, -75.0 * kPa, -50.0 * kPa, 0.0});
  for (int n = 0; n < 100; ++n) {
    point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(1e-4)});
  }
  const double limit =
      75.0 * kPa * std::sin(soil.friction_peak) + soil.cohesion_peak * std::cos(soil.friction_peak);
  EXPECT_NEAR(limit, 55.86 * kPa, 5.0);
  EXPECT_NEAR(point.stress().xy, limit, 1e-9 * limit);
}

/// With dilation psi, plastic flow on the main plane keeps dev_v / d(shear strain) = -sin(psi) in plane.
TEST(SimpleShear, VolumeGrowsWithTheDilationAngle) {
  const double dilation = 10.0 * degree;
  PointTest point = shear_drained(perfect_soil(30.0, 10.0, 10.0), 100.0 * kPa, 0.1, 400);
  const PointStrain before = point.strain();
  for (int n = 0; n < 100; ++n) {
    point.apply({Control::strain(0.0), Control::stress(-100.0 * kPa), Control::strain(1e-4)});
  }
  EXPECT_NEAR((point.strain().yy - before.yy) / (point.strain().xy - before.xy), std::tan(dilation), 1e-5);
}

} // namespace
} // namespace tremolo::materials::test
