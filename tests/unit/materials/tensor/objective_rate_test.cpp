#include "materials/law/driver.hpp"
#include "materials/tensor/material_axes.hpp"
#include "materials/tensor/objective_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
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

/// Angles of any size and increments up to the largest, against the C library; four at a time alike.
TEST(ObjectiveRate, AxesOfTheMaterialTurnByAnyAngle) {
  for (int k = -4000; k <= 4000; ++k) {
    const double angle = 0.0123 * k;
    const double w = 2.5e-4 * k;
    EXPECT_NEAR(MaterialAxes::turned(angle, w), angle + 2.0 * std::atan(0.5 * w),
                1e-15 * (1.0 + std::abs(angle)));
    const InPlaneStress s = MaterialAxes(angle).to_material({1.0, -1.0, 0.0});
    EXPECT_NEAR(s.xx, std::cos(2.0 * angle), 2e-14);
    EXPECT_NEAR(s.xy, -std::sin(2.0 * angle), 2e-14);
    const Lanes four{angle, 0.0, -angle, 2.0 * angle};
    const MaterialAxesOf<Lanes> axes(MaterialAxesOf<Lanes>::turned(four, Lanes{w, 0.0, 0.0, w}));
    const InPlaneStressOf<Lanes> turned_four = axes.to_space({Lanes{} + 2.0, Lanes{}, Lanes{} + 1.0});
    for (std::size_t i = 0; i < 4; ++i) {
      const MaterialAxes one(MaterialAxes::turned(four[i], i == 0 || i == 3 ? w : 0.0));
      const InPlaneStress turned_one = one.to_space({2.0, 0.0, 1.0});
      EXPECT_NEAR(turned_four.xx[i], turned_one.xx, 1e-13);
      EXPECT_NEAR(turned_four.xy[i], turned_one.xy, 1e-13);
    }
  }
}

} // namespace
} // namespace tremolo::materials
