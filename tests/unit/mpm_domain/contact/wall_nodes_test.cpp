// Integrals over a body's surface at nodes against closed forms.

#include "mesh/polygon_measures.hpp"
#include "mpm_domain/contact/rigid_body.hpp"
#include "mpm_domain/contact/wall_nodes.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

using test_support::circle;
using test_support::rectangle;
using test_support::structure;
using test_support::turned;

constexpr Lattice lattice{.h = 0.5, .x0 = -5.0, .y0 = -5.0, .nx = 21, .ny = 21, .first = 0};

struct Wall {
  NodeWindow window;
  std::vector<double> shares;

  explicit Wall(const RigidBody& body) : window(nodes_around(lattice, body.surface().bounds())) {
    find_wall(body.surface(), lattice, window, shares);
  }
};

TEST(WallNodes, SharesAddUpToTheSurfaceAndItsMoments) {
  const RigidBody body(structure(turned(rectangle(-1.3, -0.9, 1.1, 2.2), {0.1, 0.2}, 0.3), 2000.0, 0.5));
  const Wall wall(body);
  double length = 0.0;
  Vector moment; // hats reproduce linear fields
  for (int j = wall.window.j0; j < wall.window.j0 + wall.window.rows; ++j)
    for (int i = wall.window.i0; i < wall.window.i0 + wall.window.columns; ++i) {
      const double share = wall.shares[wall.window.index(i, j)];
      length += share;
      moment.x += (lattice.x0 + i * lattice.h) * share;
      moment.y += (lattice.y0 + j * lattice.h) * share;
    }
  const double around = 2.0 * (2.4 + 3.1);
  EXPECT_NEAR(length, around, 1e-13);
  EXPECT_NEAR(moment.x, around * body.centre().x, 1e-13);
  EXPECT_NEAR(moment.y, around * body.centre().y, 1e-13);
}

TEST(WallNodes, AnEdgeOnALineOfTheGridBelongsToThatLineAlone) {
  const RigidBody body(structure(rectangle(-1.0, 0.0, 1.0, 2.0), 2000.0, 0.5));
  const Wall wall(body);
  const auto share = [&](double x, double y) {
    return wall.shares[wall.window.index(static_cast<int>(std::lround((x - lattice.x0) / lattice.h)),
                                         static_cast<int>(std::lround((y - lattice.y0) / lattice.h)))];
  };
  EXPECT_DOUBLE_EQ(share(0.0, 0.0), 0.5);
  EXPECT_DOUBLE_EQ(share(0.0, -0.5), 0.0);
  EXPECT_DOUBLE_EQ(share(0.0, 0.5), 0.0);
}

TEST(PolygonMeasures, AreThoseOfRectanglesAndCircles) {
  const auto box = mesh::measures(turned(rectangle(100.0, 200.0, 103.0, 204.0), {101.5, 202.0}, 0.7));
  EXPECT_NEAR(box.area, 12.0, 1e-11);
  EXPECT_NEAR(box.x, 101.5, 1e-12);
  EXPECT_NEAR(box.y, 202.0, 1e-12);
  EXPECT_NEAR(box.polar, 12.0 * (9.0 + 16.0) / 12.0, 1e-10);
  const auto disc = mesh::measures(circle({3.0, -2.0}, 2.5, 256));
  EXPECT_NEAR(disc.area, std::numbers::pi * 6.25, 1e-12);
  EXPECT_NEAR(disc.polar, 0.5 * std::numbers::pi * std::pow(2.5, 4), 1e-3 * disc.polar);
}

TEST(PolygonMeasures, PartsOfARectangle) {
  const std::vector<Vector> box = rectangle(0.0, 0.0, 2.0, 1.0);
  EXPECT_DOUBLE_EQ(mesh::measures(mesh::part_below(box, 0.25)).area, 0.5);
  EXPECT_DOUBLE_EQ(mesh::measures(mesh::part_below(box, -1.0)).area, 0.0);
  const std::vector<Vector> right = mesh::clipped(box, [](const Vector& corner) { return corner.x - 1.5; });
  const auto corner =
      mesh::measures(mesh::clipped(right, [](const Vector& of_right) { return of_right.y - 0.5; }));
  EXPECT_DOUBLE_EQ(corner.area, 0.25);
  EXPECT_DOUBLE_EQ(corner.x, 1.75);
  EXPECT_DOUBLE_EQ(corner.y, 0.75);
}

TEST(RigidBody, HasTheMassOfItsOutlineLessItsHole) {
  Structure ring = structure(rectangle(-2.0, -2.0, 2.0, 2.0), 1000.0, 0.5);
  ring.hole = rectangle(-1.0, -1.0, 1.0, 1.0);
  const RigidBody body(ring);
  EXPECT_DOUBLE_EQ(body.mass(), 12000.0);
  EXPECT_NEAR(body.inertia(), 1000.0 * (std::pow(4.0, 4) - std::pow(2.0, 4)) / 6.0, 1e-9);
  // Water to the middle lifts the whole outline's lower half.
  const Head head(0.0);
  const RigidLoad load = body.load(9.81, WaterAround{head, 9810.0});
  EXPECT_NEAR(load.force.y, 8.0 * 9810.0 - 12000.0 * 9.81, 1e-8);
  EXPECT_NEAR(load.moment, 0.0, 1e-8);
}

TEST(RigidBody, RightsItselfInWaterWhenItTilts) {
  RigidBody body(structure(rectangle(-2.0, -0.5, 2.0, 0.5), 500.0, 0.5));
  body.set_motion({{0.0, 0.0}, 0.1});
  body.move(1.0);
  EXPECT_NEAR(body.tilt(), 0.1, 1e-15);
  const Head head(0.0);
  EXPECT_LT(body.load(9.81, WaterAround{head, 9810.0}).moment, 0.0); // back, clockwise
}

TEST(RigidBody, IsRefusedWithoutAreaOrWeight) {
  EXPECT_THROW(RigidBody(structure({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}, 2000.0, 0.5)),
               std::invalid_argument);
  EXPECT_THROW(RigidBody(structure(rectangle(0.0, 0.0, 1.0, 1.0), -1.0, 0.5)), std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
