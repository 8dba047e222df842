// Slopes that just carry their weight. In undrained clay, strength c without friction, a slope of height H
// stands by itself where c > N gamma H with the stability numbers N of Taylor (1948, Fundamentals of Soil
// Mechanics, fig. 16.26). With friction Griffiths and Lane (1999, Geotechnique 49, 387-403, examples 1 and 2)
// give the factor F by which c and tan phi can be divided. Nearly incompressible clay must be no stronger
// than any other.

#include "tests/verification/mpm_domain/limit_loads/slope.hpp"
#include "tests/verification/mpm_domain/limit_loads/static_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

namespace tremolo::mpm_domain {
namespace {

struct ClaySlope {
  test::Slope slope;
  double number; ///< N
  double poisson;
  Dilatation dilatation = Dilatation::cell;

  friend void PrintTo(const ClaySlope& s, std::ostream* out) {
    *out << s.slope.angle_deg << " deg, depth factor " << s.slope.depth_factor << ", cells of "
         << s.slope.cell_size << " m, nu " << s.poisson;
  }
};

/// @param strength  over that of Taylor's chart
bool stands(const ClaySlope& of, double strength) {
  constexpr double density = 1800.0;
  Spec spec = test::spec_of(
      of.slope, test::perfectly_plastic({density, 20e6, of.poisson},
                                        strength * of.number * density * test::gravity * test::height, 0.0));
  spec.scheme.dilatation = of.dilatation;
  return test::carries_its_weight(spec, 40.0);
}

class Taylor : public testing::TestWithParam<ClaySlope> {};

TEST_P(Taylor, SlopeStandsAboveItsStabilityNumberAndFailsBelowIt) {
  EXPECT_FALSE(stands(GetParam(), 0.95));
  EXPECT_TRUE(stands(GetParam(), 1.05));
}

// A slope that slides along its own base asks for finer cells: of 1 m it is 5 to 10 % too strong at 45
// degrees.
INSTANTIATE_TEST_SUITE_P(
    Angles, Taylor,
    testing::Values(ClaySlope{{30.0, 1.0, 0.5}, 0.133, 0.3}, ClaySlope{{30.0, 1.0, 0.5}, 0.133, 0.495},
                    ClaySlope{{30.0, 1.5, 1.0}, 0.164, 0.3}, ClaySlope{{30.0, 1.5, 1.0}, 0.164, 0.495},
                    ClaySlope{{30.0, 2.0, 1.0}, 0.172, 0.3}, ClaySlope{{30.0, 2.0, 1.0}, 0.172, 0.495},
                    ClaySlope{{45.0, 1.0, 0.5}, 0.164, 0.3}, ClaySlope{{45.0, 1.0, 0.5}, 0.164, 0.495},
                    ClaySlope{{45.0, 1.5, 1.0}, 0.174, 0.3}, ClaySlope{{45.0, 1.5, 1.0}, 0.174, 0.495},
                    ClaySlope{{60.0, 1.0, 1.0}, 0.191, 0.3}, ClaySlope{{60.0, 1.0, 1.0}, 0.191, 0.495},
                    ClaySlope{{60.0, 1.5, 1.0}, 0.191, 0.3}, ClaySlope{{60.0, 1.5, 1.0}, 0.191, 0.495},
                    ClaySlope{{60.0, 2.0, 1.0}, 0.191, 0.3}, ClaySlope{{60.0, 2.0, 1.0}, 0.191, 0.495}));

INSTANTIATE_TEST_SUITE_P(Meshes, Taylor,
                         testing::Values(ClaySlope{{45.0, 2.0, 2.0}, 0.177, 0.3},
                                         ClaySlope{{45.0, 2.0, 2.0}, 0.177, 0.495},
                                         ClaySlope{{45.0, 2.0, 1.0}, 0.177, 0.3},
                                         ClaySlope{{45.0, 2.0, 1.0}, 0.177, 0.495},
                                         ClaySlope{{45.0, 2.0, 0.5}, 0.177, 0.3}));

/// What the mean over a cell is there for.
TEST(Locking, MakesASlopeStandAtHalfItsStrengthWhereParticlesSeeTheirOwnDilatation) {
  EXPECT_TRUE(stands({{45.0, 2.0, 2.0}, 0.177, 0.495, Dilatation::particle}, 0.6));
  EXPECT_FALSE(stands({{45.0, 2.0, 2.0}, 0.177, 0.495, Dilatation::cell}, 0.95));
}

struct SandySlope {
  double depth_factor;
  double cell_size;
  double poisson;

  friend void PrintTo(const SandySlope& s, std::ostream* out) {
    *out << "depth factor " << s.depth_factor << ", cells of " << s.cell_size << " m, nu " << s.poisson;
  }
};

/// c = 0.05 gamma H, phi = 20 degrees, a slope of 2 to 1.
bool stands(const SandySlope& of, double factor) {
  constexpr double density = 2000.0;
  const double cohesion = 0.05 * density * test::gravity * test::height;
  return test::carries_its_weight(
      test::spec_of({std::atan(0.5) / test::degree, of.depth_factor, of.cell_size},
                    test::perfectly_plastic({density, 100e6, of.poisson}, cohesion / factor,
                                            std::atan(std::tan(20.0 * test::degree) / factor))),
      20.0);
}

class GriffithsAndLane : public testing::TestWithParam<SandySlope> {};

TEST_P(GriffithsAndLane, SlopeFailsAtItsFactor) {
  constexpr double published = 1.4;
  EXPECT_TRUE(stands(GetParam(), 0.95 * published));
  EXPECT_FALSE(stands(GetParam(), 1.05 * published));
}

INSTANTIATE_TEST_SUITE_P(Meshes, GriffithsAndLane,
                         testing::Values(SandySlope{1.0, 1.0, 0.3}, SandySlope{1.0, 1.0, 0.495},
                                         SandySlope{1.0, 0.5, 0.3}, SandySlope{1.0, 0.4, 0.3},
                                         SandySlope{1.5, 1.0, 0.3}, SandySlope{1.5, 1.0, 0.495}));

} // namespace
} // namespace tremolo::mpm_domain
