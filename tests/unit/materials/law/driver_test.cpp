#include "materials/law/driver.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace tremolo::materials {
namespace {

const LinearElastic elastic{{1700.0, 40e6, 0.28}};

/// Free lateral strain: sigma_yy = E / (1 - nu^2) eps_yy in plane strain.
TEST(PointTest, HoldsAPrescribedStress) {
  PointTest point(elastic, {});
  point.apply({Control::stress(0.0), Control::strain(-1e-3)});
  EXPECT_NEAR(point.stress().xx, 0.0, 1e-6);
  EXPECT_NEAR(point.stress().yy, -1e-3 * 40e6 / (1.0 - 0.28 * 0.28), 1e-5);
}

TEST(PointTest, FindsAllThreeStrains) {
  PointTest point(elastic, {});
  point.apply({Control::stress(-1e4), Control::stress(-2e4), Control::stress(5e3)});
  EXPECT_NEAR(point.stress().xx, -1e4, 1e-6);
  EXPECT_NEAR(point.stress().yy, -2e4, 1e-6);
  EXPECT_NEAR(point.strain().xy, 5e3 / 15.625e6, 1e-12);
}

TEST(PointTest, SaysThatALoadCannotBeCarried) {
  MohrCoulomb soil;
  soil.elastic = elastic.elastic;
  soil.cohesion_peak = soil.cohesion_residual = 10e3;
  PointTest point(soil, {});
  EXPECT_THROW(point.apply({Control::stress(0.0), Control::stress(-100e3)}), std::runtime_error);
}

TEST(PointTest, RefusesAStressThatIsNotFinite) {
  EXPECT_THROW(PointTest(elastic, {std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
}

} // namespace
} // namespace tremolo::materials
