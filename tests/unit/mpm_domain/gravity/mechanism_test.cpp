#include "mpm_domain/gravity/mechanism.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// Soil under a surface that rises by half a metre a metre, 10 m of it; what lies less than `depth` below it
/// and from x = 3 to 6 m moves.
std::vector<MovingPoint> sliding(double depth) {
  std::vector<MovingPoint> points;
  for (double x = 0.25; x < 10.0; x += 0.5)
    for (double y = 0.25; y < 5.0 + 0.5 * std::floor(x); y += 0.5) {
      const double below = 5.0 + 0.5 * std::floor(x) - y;
      const bool moves = below < depth && x > 3.0 && x < 6.0;
      points.push_back({{x, y}, 0.5, {moves ? -0.6 : 0.05, moves ? -0.8 : 0.0}, 0.0});
    }
  return points;
}

TEST(Mechanism, LiesWhereSoilMovesMeasuredFromTheSurfaceAboveIt) {
  for (const double depth : {0.5, 2.0}) {
    const auto found = extent_of(sliding(depth)).value();
    EXPECT_DOUBLE_EQ(found.x_min, 3.0);
    EXPECT_DOUBLE_EQ(found.x_max, 6.0);
    EXPECT_DOUBLE_EQ(found.depth, depth);
    EXPECT_DOUBLE_EQ(found.rows, depth / 0.5);
  }
  EXPECT_FALSE(extent_of(sliding(0.0))); // all creeps at less than a tenth
}

} // namespace
} // namespace tremolo::mpm_domain
