// A rigid rotation by 90 degrees in the middle of a cyclic test changes nothing: afterwards the same strains
// in the axes of the turned material give the same stresses, turned.

#include "materials/law/driver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::materials::test {
namespace {

/// Shear strain cycles of 0.5 % with some vertical strain, at rest or turned after `turn` steps by `steps`
/// increments of rotation to a quarter turn.
PointStress after_cycles(int turn, int steps) {
  PointTest point(pdmy03({.relative_density = 0.57}), {-50e3, -100e3, -50e3, 8e3});
  for (int k = 0; k < 8000; ++k) {
    const bool turned = k >= turn;
    if (k == turn) {
      for (int n = 0; n < steps; ++n) {
        PointStep rotation;
        rotation.rotation = 2.0 * std::tan(0.25 * std::numbers::pi / steps);
        point.apply(rotation);
      }
    }
    const double shear = (k / 1000) % 2 == 0 ? 1e-5 : -1e-5;
    const double vertical = 2e-7 * std::cos(0.01 * k);
    // x of the material is y of space after a quarter turn, and y is -x
    point.apply({Control::strain(turned ? vertical : 0.0), Control::strain(turned ? 0.0 : vertical),
                 Control::strain(turned ? -shear : shear)});
  }
  return point.stress();
}

TEST(Pdmy03Rotation, AQuarterTurnInTheMiddleOfACyclicTestChangesNothing) {
  const PointStress still = after_cycles(8001, 0);
  for (const int steps : {2, 7, 500}) {
    const PointStress turned = after_cycles(3500, steps);
    const double scale = 1e-8 * std::abs(still.xx + still.yy + still.zz);
    EXPECT_NEAR(turned.xx, still.yy, scale) << steps;
    EXPECT_NEAR(turned.yy, still.xx, scale) << steps;
    EXPECT_NEAR(turned.zz, still.zz, scale) << steps;
    EXPECT_NEAR(turned.xy, -still.xy, scale) << steps;
  }
}

} // namespace
} // namespace tremolo::materials::test
