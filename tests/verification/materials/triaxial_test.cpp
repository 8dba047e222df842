// Mohr-Coulomb in triaxial compression and extension: the corners of the pyramid, where two planes meet.

#include "soils.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo::materials::test {
namespace {

/// Axial strain along y in 100 steps under a cell pressure.
PointTest sheared(const MohrCoulomb& soil, double cell, double axial) {
  PointTest point(soil, {-cell, -cell, -cell, 0.0});
  for (int n = 0; n < 100; ++n) {
    point.apply(
        {.xx = Control::stress(-cell), .yy = Control::strain(0.01 * axial), .zz = Control::stress(-cell)});
  }
  return point;
}

TEST(Triaxial, CompressionAndExtensionFollowRankine) {
  for (const double dilation : {0.0, 10.0}) {
    const MohrCoulomb soil = perfect_soil(30.0, dilation, 10.0 * kPa);
    const double cell = 100.0 * kPa;
    const double n = flow_value(soil.friction_peak);
    const double compression = n * cell + 2.0 * soil.cohesion_peak * std::sqrt(n);
    const double extension = cell / n - 2.0 * soil.cohesion_peak / std::sqrt(n);
    const PointTest pushed = sheared(soil, cell, -0.05);
    EXPECT_NEAR(-pushed.stress().yy, compression, 1e-8 * compression);
    EXPECT_NEAR(pushed.stress().zz, pushed.stress().xx, 1e-8 * cell);
    const PointTest pulled = sheared(soil, cell, 0.05);
    EXPECT_NEAR(-pulled.stress().yy, extension, 1e-8 * compression);
    EXPECT_NEAR(pulled.stress().zz, pulled.stress().xx, 1e-8 * cell);
  }
}

/// Softening on the edge: lateral strain splits evenly, the strength is that of the plastic strain reached.
TEST(Triaxial, SofteningFollowsTheStrengthOfItsPlasticStrain) {
  const MohrCoulomb soil = slope_soil();
  const double cell = 50.0 * kPa;
  const PointTest point = sheared(soil, cell, -0.05);
  const double decay = std::exp(-soil.softening * point.state()[equivalent_plastic_strain]);
  const double n = flow_value(soil.friction_residual + (soil.friction_peak - soil.friction_residual) * decay);
  const double expected = n * cell + 2.0 * soil.cohesion_peak * decay * std::sqrt(n);
  EXPECT_NEAR(-point.stress().yy, expected, 1e-8 * expected);
  EXPECT_LT(expected, 0.8 * 310.7 * kPa);
}

} // namespace
} // namespace tremolo::materials::test
