#include "materials/law/driver.hpp"
#include "materials/tensor/objective_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::materials {
namespace {

constexpr double quarter_turn = std::numbers::pi / 2.0;

/// The rotation increment that displacements of a rigid rotation by `angle` have about their mid-step
/// configuration.
double mid_step_increment(double angle) {
  return 2.0 * std::tan(0.5 * angle);
}

InPlaneStress turned(InPlaneStress stress, double angle, int steps) {
  for (int n = 0; n < steps; ++n) {
    stress = rotated(stress, mid_step_increment(angle / steps));
  }
  return stress;
}

TEST(ObjectiveRate, QuarterTurnSwapsTheNormalStresses) {
  for (const int steps : {1, 3, 1000}) {
    const InPlaneStress s = turned({-50e3, -80e3, 10e3}, quarter_turn, steps);
    EXPECT_NEAR(s.xx, -80e3, 1e-6);
    EXPECT_NEAR(s.yy, -50e3, 1e-6);
    EXPECT_NEAR(s.xy, -10e3, 1e-6);
  }
}

TEST(ObjectiveRate, KeepsThePrincipalStressesForAnyIncrement) {
  for (const double w : {1e-6, 0.1, 3.0, -100.0}) {
    const InPlaneStress s = rotated({-50e3, -80e3, 10e3}, w);
    EXPECT_NEAR(s.xx + s.yy, -130e3, 1e-9);
    EXPECT_NEAR(std::hypot(0.5 * (s.xx - s.yy), s.xy), std::hypot(15e3, 10e3), 1e-9);
  }
}

/// The angle itself as increment: the error falls with the square of the step.
TEST(ObjectiveRate, IntegratesAnAngularVelocityToSecondOrder) {
  const auto error = [](int steps) {
    InPlaneStress s{0.0, 1.0, 0.0};
    for (int n = 0; n < steps; ++n) {
      s = rotated(s, quarter_turn / steps);
    }
    return std::abs(s.xy);
  };
  EXPECT_NEAR(std::log2(error(50) / error(100)), 2.0, 0.01);
}

/// Shears a softening soil, in half of the runs with a rigid quarter turn in the middle; the second half of
/// the strain is then given in the turned axes.
PointTest sheared(bool turn) {
  MohrCoulomb soil;
  soil.elastic = {1700.0, 40e6, 0.28};
  soil.cohesion_peak = 4e3;
  soil.friction_peak = quarter_turn / 2.0;
  soil.friction_residual = quarter_turn / 3.0;
  soil.softening = 15.0;
  PointTest point(soil, {-30e3, -60e3, -30e3, 0.0});
  const double exx = 2e-5;
  const double eyy = -3e-5;
  const double gxy = 1e-4;
  for (int n = 0; n < 200; ++n) {
    point.apply({Control::strain(exx), Control::strain(eyy), Control::strain(gxy)});
  }
  for (int n = 0; turn && n < 500; ++n) {
    PointStep rotation;
    rotation.rotation = mid_step_increment(quarter_turn / 500);
    point.apply(rotation);
  }
  for (int n = 0; n < 200; ++n) {
    point.apply(turn ? PointStep{Control::strain(eyy), Control::strain(exx), Control::strain(-gxy)}
                     : PointStep{Control::strain(exx), Control::strain(eyy), Control::strain(gxy)});
  }
  return point;
}

TEST(ObjectiveRate, ARigidQuarterTurnInTheMiddleChangesNothing) {
  const PointTest still = sheared(false);
  const PointTest turned_point = sheared(true);
  ASSERT_GT(still.state()[equivalent_plastic_strain], 1e-2);
  const double scale = std::abs(still.stress().yy);
  EXPECT_NEAR(turned_point.stress().xx, still.stress().yy, 1e-8 * scale);
  EXPECT_NEAR(turned_point.stress().yy, still.stress().xx, 1e-8 * scale);
  EXPECT_NEAR(turned_point.stress().zz, still.stress().zz, 1e-8 * scale);
  EXPECT_NEAR(turned_point.stress().xy, -still.stress().xy, 1e-8 * scale);
  EXPECT_NEAR(turned_point.state()[equivalent_plastic_strain], still.state()[equivalent_plastic_strain],
              1e-8);
  EXPECT_NEAR(turned_point.plastic_work(), still.plastic_work(), 1e-8 * still.plastic_work());
}

} // namespace
} // namespace tremolo::materials
