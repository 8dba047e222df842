#include "mesh/quadtree.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace tremolo::mesh {
namespace {

Roots roots(int nx, int ny) {
  return {.x0 = 0.0, .y0 = 0.0, .h = 1.0, .nx = nx, .ny = ny};
}

/// Leaves cover the roots without overlap, and touch only leaves of the same or a neighbouring level.
void expect_balanced(const Quadtree& tree) {
  const std::vector<Cell> leaves = tree.leaves();
  double area = 0.0;
  for (const Cell& leaf : leaves)
    area += tree.rectangle(leaf).area();
  EXPECT_NEAR(area, tree.roots().nx * tree.roots().ny, 1e-12);
  const auto touch = [](const Rectangle& a, const Rectangle& b) {
    constexpr double rounding = 1e-9;
    return a.x_min < b.x_max + rounding && b.x_min < a.x_max + rounding && a.y_min < b.y_max + rounding &&
           b.y_min < a.y_max + rounding;
  };
  for (const Cell& a : leaves)
    for (const Cell& b : leaves)
      if (touch(tree.rectangle(a), tree.rectangle(b))) {
        EXPECT_LE(std::abs(a.level - b.level), 1);
      }
}

TEST(CellSize, HalvesFromLevelToLevel) {
  EXPECT_EQ(cell_size(0.3, 0), 0.3);
  for (int level = 1; level <= finest_level_allowed; ++level)
    EXPECT_EQ(2.0 * cell_size(0.3, level), cell_size(0.3, level - 1)) << level; // exact: a power of two
}

TEST(Quadtree, WithoutRefinementIsItsRoots) {
  const Quadtree tree(roots(3, 2), {});
  EXPECT_EQ(tree.finest(), 0);
  EXPECT_EQ(tree.leaves().size(), 6U);
}

TEST(Quadtree, CutsWhatABoxOverlaps) {
  const std::vector<Refinement> boxes{{{1.0, 1.0, 2.0, 2.0}, 1}};
  const Quadtree tree(roots(4, 4), boxes);
  EXPECT_EQ(tree.leaves().size(), 15U + 4U);
  EXPECT_EQ(tree.finest_in({1.2, 1.2, 1.3, 1.3}), 1);
  EXPECT_EQ(tree.finest_in({2.2, 1.2, 2.3, 1.3}), 0);
}

TEST(Quadtree, IsBalancedByEdgesAndCorners) {
  const std::vector<Refinement> boxes{{{3.0, 3.0, 3.1, 3.1}, 4}, {{5.9, 1.0, 6.1, 1.2}, 3}};
  const Quadtree tree(roots(8, 8), boxes);
  EXPECT_EQ(tree.finest(), 4);
  expect_balanced(tree);
  EXPECT_GT(tree.cut_for_balance()[0], 0U);
}

TEST(Quadtree, IsBalancedAcrossTheSeamOfAPeriod) {
  Roots torus = roots(12, 4);
  torus.period = 8;
  torus.first_column = 2;
  const std::vector<Refinement> boxes{{{9.8, 1.0, 10.0, 1.2}, 3}}; // at the right end of the period
  const Quadtree tree(torus, boxes);
  expect_balanced(tree);
  for (int j = 0; j < 8; ++j) // what lies beyond the left side is what lies at the right one
    EXPECT_EQ(tree.is_cut({1, 3, j}), tree.is_cut({1, 3 + 16, j}));
  EXPECT_TRUE(tree.is_cut({0, 1, 1}));
}

TEST(Quadtree, ABoxBesideTheRootsCutsNothing) {
  const std::vector<Refinement> boxes{{{10.0, 10.0, 11.0, 11.0}, 2}};
  EXPECT_EQ(Quadtree(roots(4, 4), boxes).finest(), 0);
}

TEST(Quadtree, RefusesALevelOutOfRange) {
  EXPECT_THROW(Quadtree(roots(4, 4), std::vector<Refinement>{{{0.0, 0.0, 1.0, 1.0}, 9}}),
               std::invalid_argument);
  EXPECT_THROW(Quadtree(roots(4, 4), std::vector<Refinement>{{{0.0, 0.0, 1.0, 1.0}, -1}}),
               std::invalid_argument);
}

} // namespace
} // namespace tremolo::mesh
