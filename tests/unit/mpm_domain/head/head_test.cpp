#include "mpm_domain/head/head.hpp"

#include <gtest/gtest.h>

namespace tremolo::mpm_domain {
namespace {

TEST(Head, BelowALevelTableIsOneEverywhere) {
  const Head head(-2.0);
  ASSERT_NE(head.level(), nullptr);
  EXPECT_EQ(*head.level(), -2.0);
  EXPECT_TRUE(head.is_wet(100.0, -2.1));
  EXPECT_FALSE(head.is_wet(-100.0, -1.9));
  EXPECT_EQ(head.at(3.0, -5.0).slope.x, 0.0);
  EXPECT_EQ(head.surface(0.0, -10.0, 0.0), -2.0);
}

TEST(Head, BelowALineIsThatOfTheLineAbove) {
  const Head head(std::vector<Vector>{{0.0, 4.0}, {10.0, 2.0}, {20.0, 2.0}});
  EXPECT_EQ(head.level(), nullptr);
  EXPECT_DOUBLE_EQ(head.at(5.0, -3.0).head, 3.0);
  EXPECT_DOUBLE_EQ(head.at(5.0, -3.0).slope.x, -0.2);
  EXPECT_EQ(head.at(5.0, -3.0).slope.y, 0.0);
  EXPECT_DOUBLE_EQ(head.at(15.0, 0.0).head, 2.0);
  EXPECT_EQ(head.at(-5.0, 0.0).head, 4.0); // level beyond its ends
  EXPECT_EQ(head.at(-5.0, 0.0).slope.x, 0.0);
  EXPECT_EQ(head.at(25.0, 0.0).head, 2.0);
  EXPECT_DOUBLE_EQ(head.surface(5.0, 0.0, 10.0), 3.0);
  EXPECT_EQ(head.surface(5.0, 0.0, 2.5), 2.5);
}

/// Nodes 2 m apart with h = 6 + 0.5 x - 0.25 y + 0.1 x y.
HeadGrid bilinear() {
  HeadGrid grid{.x0 = 1.0, .y0 = -1.0, .h = 2.0, .columns = 4, .rows = 3};
  for (std::size_t j = 0; j < grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const Vector at = grid.position(i, j);
      grid.heads.push_back(6.0 + 0.5 * at.x - 0.25 * at.y + 0.1 * at.x * at.y);
    }
  return grid;
}

TEST(Head, OnAGridIsBilinearBetweenItsNodes) {
  const Head head(bilinear());
  for (const double x : {1.0, 2.2, 5.5, 7.0})
    for (const double y : {-1.0, 0.3, 2.9}) {
      const HeadThere there = head.at(x, y);
      EXPECT_NEAR(there.head, 6.0 + 0.5 * x - 0.25 * y + 0.1 * x * y, 1e-12);
      EXPECT_NEAR(there.slope.x, 0.5 + 0.1 * y, 1e-12);
      EXPECT_NEAR(there.slope.y, -0.25 + 0.1 * x, 1e-12);
    }
}

TEST(Head, BeyondAGridIsThatOfItsEdge) {
  const Head head(bilinear());
  EXPECT_EQ(head.at(0.0, 0.5).head, head.at(1.0, 0.5).head);
  EXPECT_EQ(head.at(0.0, 0.5).slope.x, 0.0);
  EXPECT_EQ(head.at(3.0, 9.0).head, head.at(3.0, 3.0).head);
  EXPECT_EQ(head.at(3.0, 9.0).slope.y, 0.0);
}

TEST(Head, OnAGridHasItsSurfaceWhereThePressureIsZero) {
  // h = 3 - y/2: the pressure is zero at y = 2.
  HeadGrid grid{.x0 = 0.0, .y0 = 0.0, .h = 1.0, .columns = 2, .rows = 6};
  for (std::size_t j = 0; j < grid.rows; ++j)
    grid.heads.insert(grid.heads.end(), 2, 3.0 - 0.5 * static_cast<double>(j));
  const Head head(grid);
  EXPECT_NEAR(head.surface(0.5, 0.0, 5.0), 2.0, 1e-12);
  EXPECT_EQ(head.surface(0.5, 0.0, 1.0), 1.0);
  EXPECT_EQ(head.surface(0.5, 3.0, 5.0), 3.0);
}

} // namespace
} // namespace tremolo::mpm_domain
