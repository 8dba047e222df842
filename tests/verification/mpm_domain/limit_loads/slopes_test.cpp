// Slopes that just carry their weight (known_slopes.hpp). Nearly incompressible clay must be no stronger than
// any other. More meshes: cost_limit_loads.

#include "tests/verification/mpm_domain/limit_loads/expect_limit.hpp"
#include "tests/verification/mpm_domain/limit_loads/known_slopes.hpp"

#include <gtest/gtest.h>

namespace tremolo::mpm_domain {
namespace {

using test::ClaySlope;
using test::SandySlope;

class Taylor : public testing::TestWithParam<ClaySlope> {};

TEST_P(Taylor, SlopeStandsAboveItsStabilityNumberAndFailsBelowIt) {
  expect_stands(GetParam(), 0.95, false);
  expect_stands(GetParam(), 1.05, true);
}

// A slope that slides along its own base asks for finer cells: of 1 m it is 5 to 10 % too strong at 45
// degrees.
INSTANTIATE_TEST_SUITE_P(Angles, Taylor, testing::Values(ClaySlope{{60.0, 1.0, 1.0}, 0.495}));

INSTANTIATE_TEST_SUITE_P(AcceptanceAngles, Taylor,
                         testing::Values(ClaySlope{{30.0, 1.0, 0.5}, 0.3}, ClaySlope{{30.0, 1.0, 0.5}, 0.495},
                                         ClaySlope{{30.0, 1.5, 1.0}, 0.3}, ClaySlope{{30.0, 1.5, 1.0}, 0.495},
                                         ClaySlope{{30.0, 2.0, 1.0}, 0.3}, ClaySlope{{30.0, 2.0, 1.0}, 0.495},
                                         ClaySlope{{45.0, 1.0, 0.5}, 0.3}, ClaySlope{{45.0, 1.0, 0.5}, 0.495},
                                         ClaySlope{{45.0, 1.5, 1.0}, 0.3}, ClaySlope{{45.0, 1.5, 1.0}, 0.495},
                                         ClaySlope{{60.0, 1.0, 1.0}, 0.3}, ClaySlope{{60.0, 1.5, 1.0}, 0.3},
                                         ClaySlope{{60.0, 1.5, 1.0}, 0.495}, ClaySlope{{60.0, 2.0, 1.0}, 0.3},
                                         ClaySlope{{60.0, 2.0, 1.0}, 0.495}));

INSTANTIATE_TEST_SUITE_P(Meshes, Taylor, testing::Values(ClaySlope{{45.0, 2.0, 2.0}, 0.495}));

INSTANTIATE_TEST_SUITE_P(AcceptanceMeshes, Taylor,
                         testing::Values(ClaySlope{{45.0, 2.0, 2.0}, 0.3}, ClaySlope{{45.0, 2.0, 1.0}, 0.3},
                                         ClaySlope{{45.0, 2.0, 1.0}, 0.495},
                                         ClaySlope{{45.0, 2.0, 0.5}, 0.3}));

/// What the mean over a cell is there for.
TEST(Locking, MakesASlopeStandAtHalfItsStrengthWhereParticlesSeeTheirOwnDilatation) {
  EXPECT_TRUE(stands(ClaySlope{{45.0, 2.0, 2.0}, 0.495, Dilatation::particle}, 0.6));
  EXPECT_FALSE(stands(ClaySlope{{45.0, 2.0, 2.0}, 0.495, Dilatation::cell}, 0.95));
}

class GriffithsAndLane : public testing::TestWithParam<SandySlope> {};

TEST_P(GriffithsAndLane, SlopeFailsAtItsFactor) {
  expect_stands(GetParam(), 0.95, true);
  expect_stands(GetParam(), 1.05, false);
}

INSTANTIATE_TEST_SUITE_P(Meshes, GriffithsAndLane, testing::Values(SandySlope{1.0, 1.0, 0.495}));

INSTANTIATE_TEST_SUITE_P(AcceptanceMeshes, GriffithsAndLane,
                         testing::Values(SandySlope{1.0, 1.0, 0.3}, SandySlope{1.0, 0.5, 0.3},
                                         SandySlope{1.0, 0.4, 0.3}, SandySlope{1.5, 1.0, 0.3},
                                         SandySlope{1.5, 1.0, 0.495}));

} // namespace
} // namespace tremolo::mpm_domain
