#include "materials/law/driver.hpp"
#include "materials/law/mixed_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::materials {
namespace {

const Elasticity elastic = {1700.0, 40e6, 0.28};

MohrCoulomb perfect_soil() {
  MohrCoulomb soil;
  soil.elastic = elastic;
  soil.cohesion_peak = soil.cohesion_residual = 10e3;
  soil.friction_peak = soil.friction_residual = 0.5;
  return soil;
}

/// Steps that repeat themselves in a linear law are guessed right: one trial and the update that is kept.
TEST(MixedControl, RepeatedStepsNeedNoIteration) {
  PointTest point(LinearElastic{elastic}, {-50e3, -100e3, -50e3, 0.0});
  const PointStep step = {Control::stress(-50e3), Control::strain(-1e-5)};
  point.apply(step);
  const std::size_t first = point.updates();
  constexpr std::size_t steps = 100;
  for (std::size_t k = 0; k < steps; ++k) {
    point.apply(step);
  }
  EXPECT_LE(point.updates() - first, 2 * steps + 4);
  EXPECT_NEAR(point.strain().xx, 101e-5 * 0.28 / 0.72, 1e-12); // nu/(1 - nu)
}

/// With out-of-plane stress held too the law is in triaxial compression: E and nu.
TEST(MixedControl, HoldsTheStressOutOfPlane) {
  PointTest point(LinearElastic{elastic}, {-50e3, -50e3, -50e3, 0.0});
  PointStep step = {Control::stress(-50e3), Control::strain(-1e-4)};
  step.zz = Control::stress(-50e3);
  point.apply(step);
  EXPECT_NEAR(point.stress().yy, -50e3 - 40e6 * 1e-4, 1e-4);
  EXPECT_NEAR(point.strain().zz, 0.28e-4, 1e-13);
  EXPECT_NEAR(point.strain().xx, 0.28e-4, 1e-13);
}

TEST(MixedControl, RefusesOutOfPlaneStrainOfALawOfPlaneStrain) {
  PointTest point(MasingShear{elastic, 1e-3}, {-50e3, -100e3, -50e3, 0.0});
  PointStep step;
  step.zz = Control::strain(1e-5);
  EXPECT_THROW(point.apply(step), std::invalid_argument);
}

/// Water that this step compresses carries its share: sigma' + K_w/n tr(eps) is what is prescribed.
TEST(MixedControl, SharesALoadWithPoreWater) {
  PointTest point(LinearElastic{elastic}, {});
  const double water = 5e9;
  PointStep step;
  step.yy = Control::stress(-10e3);
  step.pore_stiffness = water;
  point.apply(step);
  EXPECT_NEAR(point.stress().yy, -10e3 * elastic.p_modulus() / (elastic.p_modulus() + water), 1e-5);
}

/// A stress jump of half the strength in one step, then far into yielding: followed by cutting steps.
TEST(MixedControl, FollowsALargeStepAcrossTheYieldSurface) {
  PointTest point(perfect_soil(), {-50e3, -50e3, -50e3, 0.0});
  point.apply({Control::stress(-50e3), Control::strain(-0.05)});
  const double flow = (1.0 + std::sin(0.5)) / (1.0 - std::sin(0.5));
  EXPECT_NEAR(point.stress().yy, -(flow * 50e3 + 2.0 * 10e3 * std::sqrt(flow)), 1.0);
  EXPECT_NEAR(point.stress().xx, -50e3, 1e-5);
}

TEST(MixedControl, LeavesThePointAsItWasWhenItFails) {
  PointTest point(perfect_soil(), {-50e3, -50e3, -50e3, 0.0});
  const PointState before = point.now();
  EXPECT_THROW(point.apply({Control::stress(-50e3), Control::stress(-1e6)}), std::runtime_error);
  EXPECT_EQ(point.stress().yy, before.stress.yy);
  EXPECT_EQ(point.strain().yy, before.strain.yy);
  EXPECT_EQ(point.state(), before.variables);
}

/// Reversals change the stiffness of a hysteretic law at once: every stress is met all the same.
TEST(MixedControl, MeetsStressesThroughReversalsOfAHystereticLaw) {
  PointTest point(MasingShear{elastic, 3e-4, 1.0, 0.9}, {-50e3, -100e3, -50e3, 0.0});
  for (const double target : {1e3, 2e3, 1.9e3, -2e3, -2.5e3, 2.5e3, 3e3, 0.0}) {
    point.apply({Control::strain(0.0), Control::strain(0.0), Control::stress(target)});
    EXPECT_NEAR(point.stress().xy, target, 1e-5);
  }
}

/// Soil that stiffens: the tangent of the start leads far beyond what the law accepts.
TEST(MixedControl, ComesBackFromTrialsThatAreRefused) {
  MixedStep step;
  step.by_stress = {false, true, false, false};
  step.value = {0.0, -50e3, 0.0, 0.0};
  int refused = 0;
  const StressAfter stiffening = [&](const Components& strain, Components& stress) {
    if (std::abs(strain[1]) > 1e-3) {
      ++refused;
      return false;
    }
    stress[1] = 1e3 * std::sinh(1e4 * strain[1]);
    return true;
  };
  MixedControl control;
  const MixedControl::Found found = control.find(step, stiffening, 1e-6, 1e-6);
  EXPECT_GT(refused, 0);
  EXPECT_LE(found.missing, 1e-6);
  EXPECT_NEAR(found.strain[1], -1e-4 * std::asinh(50.0), 1e-12);
}

/// One free component under shear in equal steps: sigma_yy after them, as a function of the free increment.
class Branches {
public:
  explicit Branches(double (*stress)(double)) : stress_(stress) {}

  MixedControl::Found step(MixedControl& control) const {
    MixedStep step;
    step.by_stress = {false, true, false, false};
    step.value = {0.0, 0.0, shear, 0.0};
    return control.find(
        step,
        [this](const Components& strain, Components& stress) {
          stress[1] = stress_(strain[1] / shear);
          return true;
        },
        1e-6, 1e-3);
  }

  static constexpr double shear = 1e-5;

private:
  double (*stress_)(double);
};

constexpr double far_root = -1.9;

double one_root(double x) {
  return 400.0 * (x + 0.1);
}
/// Near zero it is as steep the wrong way as the far root is the right one, so that a tangent from x = -0.1
/// leads to the far root; roots at -0.14, -0.3 and -0.38.
double three_roots(double x) {
  return 1e5 * (x + 0.14) * (x + 0.30) * (x + 0.38);
}
double only_a_far_root(double x) {
  return x > -1.0 ? 100.0 + 400.0 * std::pow(x + 0.5, 2) : 2000.0 / 9.0 * (x - far_root);
}

TEST(MixedControl, TakesTheRootNextToWhereTheStepsHaveBeenGoing) {
  MixedControl control;
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(Branches(one_root).step(control).strain[1], -0.1 * Branches::shear, 1e-12);
  }
  const auto found = Branches(three_roots).step(control);
  EXPECT_NEAR(found.strain[1], -0.14 * Branches::shear, 1e-9 * Branches::shear);
  EXPECT_EQ(found.leap, 0.0);
}

TEST(MixedControl, TellsALeapAndComesBackWhenTheRootNearbyDoes) {
  MixedControl control;
  for (int k = 0; k < 3; ++k) {
    EXPECT_FALSE(Branches(one_root).step(control).away);
  }
  for (int k = 0; k < 2; ++k) {
    const auto found = Branches(only_a_far_root).step(control);
    EXPECT_NEAR(found.strain[1], far_root * Branches::shear, 1e-6 * Branches::shear);
    EXPECT_TRUE(found.away);
    EXPECT_NEAR(found.leap, k == 0 ? 1.8 * Branches::shear : 0.0, 1e-5 * Branches::shear); // told once
  }
  // The far root is still there, and next to the last increments.
  const auto both = [](double x) { return (x + 0.12) * (x - far_root) * 400.0; };
  const auto found = Branches(both).step(control);
  EXPECT_NEAR(found.strain[1], -0.12 * Branches::shear, 1e-6 * Branches::shear);
  EXPECT_FALSE(found.away);
  EXPECT_EQ(found.leap, 0.0);
}

} // namespace
} // namespace tremolo::materials
