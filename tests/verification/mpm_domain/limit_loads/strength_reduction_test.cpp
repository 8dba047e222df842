// Factors of safety by strength reduction, against Griffiths and Lane (1999, a slope on a layer of half its
// height) and against Taylor's stability number (1948), by which undrained clay of strength F N gamma H has
// the factor F (known_slopes.hpp).

#include "mpm_domain/gravity/strength_reduction.hpp"
#include "tests/verification/mpm_domain/limit_loads/known_slopes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// 45 degrees, clay over rock at 1.5 times the height, F times the strength that just carries it.
Spec taylor(double factor, double poisson = 0.495) {
  return test::spec_of(test::ClaySlope{{45.0, 1.5, 1.0}, poisson}, factor);
}

TEST(StrengthReduction, FindsTheFactorOfGriffithsAndLane) {
  std::vector<StrengthTrial> trials;
  const auto found = factor_of_safety(spec_of(test::SandySlope{1.5, 1.0, 0.3}, 1.0), 0.04,
                                      [&](const StrengthTrial& trial) { trials.push_back(trial); });
  EXPECT_NEAR(*found.stands, test::griffiths_and_lane, 0.05 * test::griffiths_and_lane);
  EXPECT_LE(*found.fails, 1.04 * *found.stands);
  EXPECT_GT(*found.fails, *found.stands);
  EXPECT_EQ(trials.front().factor, 1.0);
  for (const StrengthTrial& trial : trials)
    EXPECT_EQ(trial.stands, trial.factor <= *found.stands) << trial.factor;
}

TEST(AcceptanceStrengthReduction, FindsFactorsBelowOne) {
  const auto found = factor_of_safety(taylor(0.7, 0.3), 0.04, [](const StrengthTrial&) {});
  EXPECT_NEAR(0.5 * (*found.stands + *found.fails), 0.7, 0.05 * 0.7);
}

/// One trial answers a floor. What fails is a circle through the toe or below it: the crest goes down, the
/// ground before the toe goes up or outwards, and what lies behind and below rests.
TEST(StrengthReduction, ShowsTheSoilThatFails) {
  int trials = 0;
  const auto found = try_factor(taylor(1.0, 0.3), 1.1, [&](const StrengthTrial&) { ++trials; });
  EXPECT_EQ(trials, 1);
  EXPECT_EQ(found.fails, 1.1);
  EXPECT_FALSE(found.stands);
  double fastest = 0.0;
  double strained = 0.0;
  for (const MovingPoint& point : found.mechanism) {
    const double speed = std::hypot(point.velocity.x, point.velocity.y);
    fastest = std::max(fastest, speed);
    strained = std::max(strained, point.plastic_strain);
    if (point.position.x < 4.0 || point.position.x > 48.0) {
      EXPECT_LT(speed, 0.1) << point.position.x << ", " << point.position.y;
    }
  }
  EXPECT_NEAR(fastest, 1.0, 1e-12);
  EXPECT_GT(strained, 0.01);
  // The toe stands at x = 18 m, the crest at 28 m.
  double down = 0.0;
  double crest = 0.0;
  for (const MovingPoint& point : found.mechanism)
    if (point.position.y > 9.0 && point.position.x < 31.0) {
      down += point.velocity.y;
      crest += 1.0;
    }
  EXPECT_LT(down / crest, -0.3);
}

TEST(StrengthReduction, RefusesSoilThatCarriesAnyLoad) {
  Spec elastic = taylor(1.0);
  elastic.soils.front().law = materials::LinearElastic{{1800.0, 20e6, 0.3}};
  EXPECT_THROW(factor_of_safety(elastic, 0.02, [](const StrengthTrial&) {}), std::invalid_argument);
  EXPECT_THAT(reducible_soils(elastic).kept, testing::ElementsAre("soil"));
  EXPECT_THAT(reducible_soils(taylor(1.0)).reduced, testing::ElementsAre("soil"));
}

/// Level ground of clay: it stands whatever its strength.
Spec level() {
  Spec flat = taylor(1.0);
  flat.regions.front().polygon = {{0.0, -5.0}, {8.0, -5.0}, {8.0, 0.0}, {0.0, 0.0}};
  flat.box = {0.0, -5.0, 8.0, 0.0};
  return flat;
}

TEST(StrengthReduction, SaysThatNothingFails) {
  const auto found = factor_of_safety(level(), 0.02, [](const StrengthTrial&) {});
  EXPECT_EQ(found.stands, largest_factor);
  EXPECT_FALSE(found.fails);
  EXPECT_TRUE(found.mechanism.empty());
}

/// Under a load of a hundred times what its clay can carry, ten times the strength is no help.
TEST(StrengthReduction, SaysThatTheGroundFailsWithTenTimesItsStrength) {
  Spec overloaded = level();
  overloaded.soils.front().law = test::perfectly_plastic({1800.0, 20e6, 0.3}, 1e3, 0.0);
  overloaded.loads = {{2.0, 6.0, 500e3, 0.0}};
  const auto found = factor_of_safety(overloaded, 0.02, [](const StrengthTrial&) {});
  EXPECT_FALSE(found.stands);
  EXPECT_EQ(found.fails, least_factor);
  EXPECT_FALSE(found.mechanism.empty());
}

TEST(StrengthReduction, AnswersAFloorByOneTrial) {
  int trials = 0;
  const auto count = [&](const StrengthTrial&) { ++trials; };
  EXPECT_EQ(try_factor(taylor(1.0, 0.3), 0.9, count).stands, 0.9);
  EXPECT_EQ(trials, 1);
}

} // namespace
} // namespace tremolo::mpm_domain
