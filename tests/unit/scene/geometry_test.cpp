#include "scene/geometry.hpp"
#include "scene/meeting_boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tremolo::scene {
namespace {

const Polygon square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const Polygon notched = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}; // a notch from above

Polygon moved(Polygon polygon, double dx, double dy) {
  for (Point& p : polygon)
    p = {p.x + dx, p.y + dy};
  return polygon;
}

Polygon reversed(Polygon polygon) {
  std::ranges::reverse(polygon);
  return polygon;
}

TEST(Geometry, AreaInEitherSense) {
  EXPECT_DOUBLE_EQ(area(square), 4.0);
  EXPECT_DOUBLE_EQ(area(reversed(square)), 4.0);
  EXPECT_DOUBLE_EQ(area(notched), 16.0 - 6.0); // the notch is a triangle of width 4 and height 3
}

TEST(Geometry, ContainsIncludesTheEdge) {
  EXPECT_TRUE(contains(square, {1, 1}));
  EXPECT_TRUE(contains(square, {2, 1}));
  EXPECT_TRUE(contains(square, {0, 2}));
  EXPECT_FALSE(contains(square, {2.001, 1}));
  EXPECT_FALSE(contains(notched, {2, 2}));
  EXPECT_TRUE(contains(notched, {0.1, 3}));
}

TEST(Geometry, SelfIntersection) {
  EXPECT_FALSE(intersects_itself(square));
  EXPECT_FALSE(intersects_itself(reversed(notched)));
  EXPECT_TRUE(intersects_itself({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));         // bow tie
  EXPECT_TRUE(intersects_itself({{0, 0}, {4, 0}, {2, 0}}));                 // folds back on itself
  EXPECT_TRUE(intersects_itself({{0, 0}, {2, 0}, {2, 0}, {0, 2}}));         // a corner twice
  EXPECT_TRUE(intersects_itself({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})); // a corner on an edge
  EXPECT_FALSE(
      intersects_itself({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})); // a corner in a straight edge is fine
}

TEST(Geometry, TouchingIsNoOverlap) {
  EXPECT_FALSE(overlap(square, moved(square, 2, 0)));       // along an edge
  EXPECT_FALSE(overlap(square, moved(square, 2, 1)));       // along half an edge
  EXPECT_FALSE(overlap(square, moved(square, 2, 2)));       // at a corner
  EXPECT_FALSE(overlap(square, moved(square, 5, 0)));       // apart
  EXPECT_FALSE(overlap(notched, {{0, 4}, {2, 1}, {4, 4}})); // the notch filled exactly
  EXPECT_FALSE(overlap({{0.1, 0}, {0.3, 0}, {0.3, 0.7}},
                       {{0.1, 0}, {0.3, 0.7}, {0.1, 0.7}})); // a diagonal that rounds
}

TEST(Geometry, Overlap) {
  EXPECT_TRUE(overlap(square, moved(square, 1, 1)));
  EXPECT_TRUE(overlap(square, square));
  EXPECT_TRUE(overlap(square, reversed(square)));
  EXPECT_TRUE(overlap(square, {{0.5, 0.5}, {1, 0.5}, {1, 1}})); // inside
  EXPECT_TRUE(overlap({{0.5, 0.5}, {1, 0.5}, {1, 1}}, square)); // around
  EXPECT_TRUE(overlap({{-1, 0.5}, {3, 0.5}, {3, 1}, {-1, 1}},
                      square));                           // a cross: no corner of either inside the other
  EXPECT_TRUE(overlap(square, {{0, 0}, {2, 0}, {2, 2}})); // half of it, edges shared
}

/// Corners of a star around (x, y) that does not cross itself, listed around it.
Polygon star(std::size_t corners, double x, double y, double inner_radius = 0.5) {
  Polygon polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    const double radius = i % 2 == 0 ? 1.0 : inner_radius;
    polygon.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return polygon;
}

TEST(Geometry, ManyCornersAreSimpleOrNot) {
  Polygon polygon = star(20001, 0.0, 0.0, 0.99); // an odd number: two neighbours are outer corners
  EXPECT_FALSE(intersects_itself(polygon));
  std::swap(polygon[5000], polygon[5100]);
  EXPECT_TRUE(intersects_itself(polygon));
}

TEST(Geometry, CirclesHaveTheirArea) {
  const Polygon polygon = circle({3.0, -4.0}, 2.5);
  EXPECT_EQ(polygon.size(), 64U);
  EXPECT_NEAR(area(polygon), std::numbers::pi * 6.25, 1e-13);
  EXPECT_TRUE(contains(polygon, {3.0, -1.51}));
  EXPECT_FALSE(contains(polygon, {3.0, -1.49}));
}

TEST(Geometry, EnclosesWhatLiesInsideAndTouchesNoEdge) {
  EXPECT_TRUE(encloses(moved(square, -1.0, -1.0), {{-0.5, -0.5}, {0.5, -0.5}, {0.0, 0.5}}));
  EXPECT_FALSE(encloses(square, square));
  EXPECT_FALSE(encloses(square, {{0.5, 0.0}, {1.5, 0.5}, {0.5, 0.5}})); // a corner on the edge
  EXPECT_FALSE(encloses({{0.5, 0.5}, {1.5, 0.5}, {1.0, 1.5}}, square));
  EXPECT_FALSE(encloses(square, moved(square, 5.0, 0.0)));
  // Both ends inside, but the edge between them crosses the notch.
  EXPECT_FALSE(encloses(notched, {{0.5, 2.0}, {0.5, 0.5}, {3.5, 0.5}, {3.5, 2.0}}));
  EXPECT_TRUE(encloses(notched, {{0.5, 0.5}, {3.5, 0.5}, {2.0, 0.9}}));
}

TEST(Geometry, PiecesOfEdgesBelowALevel) {
  double way = 0.0;
  std::size_t pieces = 0;
  for (const Polygon& polygon : {square, reversed(square)})
    for_pieces(polygon, 0.5, 0.3, [&](Point from, Point to) {
      const double length = std::hypot(to.x - from.x, to.y - from.y);
      EXPECT_LE(length, 0.3 + 1e-12);
      EXPECT_LE(std::max(from.y, to.y), 0.5);
      way += length;
      ++pieces;
    });
  EXPECT_NEAR(way, 2.0 * (2.0 + 0.5 + 0.5), 1e-12);
  EXPECT_EQ(pieces, 2U * (7U + 2U + 2U));
}

TEST(Geometry, OverlapsAmongManyPolygons) {
  // 40 x 40 stars side by side, touching at most; then one more upon the one in the middle.
  std::vector<Polygon> polygons;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j)
      polygons.push_back(star(8, 2.0 * i, 2.0 * j));
  EXPECT_TRUE(overlaps(polygons).empty());
  polygons.push_back(star(8, 40.1, 40.0));
  EXPECT_EQ(overlaps(polygons), (std::vector<std::pair<std::size_t, std::size_t>>{{20 * 40 + 20, 1600}}));
}

TEST(Geometry, OverlapsInAStackAreNamedOnceEach) {
  const auto pairs = overlaps(std::vector<Polygon>(1000, star(8, 0.0, 0.0)));
  ASSERT_EQ(pairs.size(), 999U);
  for (const auto& [first, second] : pairs)
    EXPECT_EQ(first, 0U) << second;
}

} // namespace
} // namespace tremolo::scene
