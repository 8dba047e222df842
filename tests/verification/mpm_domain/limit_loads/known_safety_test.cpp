// Factors of safety that are known (known_safety.hpp): each model stands 5 % below its factor and fails 5 %
// above.

#include "mpm_domain/gravity/held_soil.hpp"
#include "mpm_domain/gravity/strength_reduction.hpp"
#include "tests/support/hard_case.hpp"
#include "tests/verification/mpm_domain/limit_loads/known_safety.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test::BishopSlope;

bool stands_with(const Spec& spec, double factor) {
  return try_factor(spec, factor, [](const StrengthTrial&) {}).stands.has_value();
}

void expect_factor(const std::string& what, const Spec& spec, double factor, double tolerance = 0.05) {
  test_support::exactly(what + " stands just below its factor", stands_with(spec, (1.0 - tolerance) * factor),
                        true);
  test_support::exactly(what + " stands just above its factor", stands_with(spec, (1.0 + tolerance) * factor),
                        false);
}

class Bishop : public testing::TestWithParam<BishopSlope> {};

TEST_P(Bishop, SlopeHasTheFactorOfItsCircle) {
  expect_factor(testing::PrintToString(GetParam()), spec_of(GetParam()), GetParam().factor);
}

INSTANTIATE_TEST_SUITE_P(Slopes, Bishop,
                         testing::Values(BishopSlope{3.0, 30.0, 0.025, 2000.0 * 9.81, true, 1.0, 2.58}));
INSTANTIATE_TEST_SUITE_P(AcceptanceSlopes, Bishop,
                         testing::Values(BishopSlope{2.0, 20.0, 0.05, 20e3, false, 1.0, 1.383},
                                         BishopSlope{2.0, 20.0, 0.05, 20e3, true, 1.0, 1.82},
                                         BishopSlope{3.0, 30.0, 0.025, 2000.0 * 9.81, false, 1.0, 2.256}));

// So near to its factor it takes longer than 60 periods of its depth to come to rest.
TEST(PatientBishop, SlopeStandsHalfAPerCentBelowItsFactor) {
  const BishopSlope slope{2.0, 20.0, 0.05, 20e3, false, 1.0, 1.383};
  EXPECT_TRUE(stands_with(spec_of(slope), 0.9955 * slope.factor));
}

// The staircase that a slope is in cells ravels; what slides below it counts.
TEST(SlopeOfSand, SlidesAtTheTangentOfItsFrictionOverThatOfTheSlope) {
  expect_factor("PM4Sand at 20 degrees", test::sand_slope(1.0), test::sand_factor());
}

// A cut asks for finer cells than a slope: of 1 m it is 5 % too strong.
TEST(VerticalCut, StandsAsLimitAnalysisHasIt) {
  expect_factor("vertical cut in clay, cells of 1 m", test::vertical_cut(1.0, 1.0), 1.0, 0.1);
}
TEST(AcceptanceVerticalCut, StandsAsLimitAnalysisHasIt) {
  expect_factor("vertical cut in clay, cells of 0.5 m", test::vertical_cut(0.5, 1.0), 1.0);
}

// The strength is twice what the load needs.
TEST(StripLoad, FailsAtPrandtlsLoadAndTheGroundWithoutItNever) {
  const Spec clay = test::strip_load(0.25, 2.0);
  expect_factor("strip load on clay", clay, 2.0);
  Spec unloaded = clay;
  unloaded.loads.clear();
  EXPECT_TRUE(stands_with(unloaded, largest_factor));
}

TEST(Ridge, HasTheFactorOfItsStrongerSlopeWhereTheWeakerOneIsHeld) {
  const Spec ridge = test::ridge(1.0);
  EXPECT_FALSE(stands_with(ridge, 1.0)); // the left slope
  EXPECT_TRUE(stands_with(held_beside(ridge, 38.0, 70.0), 0.95 * 1.383));
}

TEST(AcceptanceRidge, HasTheFactorOfItsStrongerSlopeWhereTheWeakerOneIsHeld) {
  const Spec ridge = test::ridge(1.0);
  expect_factor("right slope of a ridge", held_beside(ridge, 38.0, 70.0), 1.383);
  // Too near to each other, the verticals keep the crest from sliding.
  EXPECT_TRUE(stands_with(held_beside(ridge, 46.0, 66.0), 1.40));
  EXPECT_FALSE(stands_with(held_beside(ridge, 38.0, 70.0), 1.40));
}

} // namespace
} // namespace tremolo::mpm_domain
