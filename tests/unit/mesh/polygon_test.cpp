#include "mesh/polygon.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tremolo::mesh {
namespace {

struct Corner {
  double x;
  double y;
};

/// An L of three unit squares, in both senses of rotation.
const std::vector<Corner> there = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
const std::vector<Corner> back(there.rbegin(), there.rend());

TEST(Polygon, InsideIsWhereTheOutlineWindsAround) {
  for (const auto& shape : {there, back}) {
    EXPECT_TRUE(inside(shape, 0.5, 0.5));
    EXPECT_TRUE(inside(shape, 1.5, 0.5));
    EXPECT_TRUE(inside(shape, 0.5, 1.5));
    EXPECT_FALSE(inside(shape, 1.5, 1.5));
    EXPECT_FALSE(inside(shape, -0.5, 0.5));
    EXPECT_FALSE(inside(shape, 2.5, 0.5));
  }
  EXPECT_FALSE(inside(std::vector<Corner>{}, 0.0, 0.0));
}

TEST(Polygon, SlopingEdgesDivideWhereTheirLineLies) {
  const std::vector<Corner> triangle = {{0, 0}, {4, 0}, {0, 2}}; // x + 2 y < 4
  EXPECT_TRUE(inside(triangle, 1.9, 1.0));
  EXPECT_FALSE(inside(triangle, 2.1, 1.0));
}

} // namespace
} // namespace tremolo::mesh
