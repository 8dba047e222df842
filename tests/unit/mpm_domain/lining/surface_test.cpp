// The surface of a lining: how it is cut, and what it passes on.

#include "tests/support/lined_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

Lining box_lining() {
  Lining lining = ring_lining();
  lining.outline = {{-2.0, -1.0}, {0.0, -1.0}, {2.0, -1.0}, {2.0, 1.0}, {0.0, 1.0}, {-2.0, 1.0}};
  return lining;
}

TEST(LiningSurface, IsCutIntoSegmentsOfAboutACell) {
  const Lining ring = ring_lining();
  const Beam beam(shape_of(ring), ring.section);
  const LiningSurface surface(ring, beam, 0.5);
  EXPECT_EQ(surface.segments().size(), 40U); // 2 pi 3.15/0.5 = 39.6
  for (const SurfaceSegment& segment : surface.segments()) {
    Vector middle{};
    for (const SurfacePoint& point : segment.points) {
      const Vector at = position_of(point, beam);
      EXPECT_NEAR(std::hypot(at.x, at.y), 3.15, 0.006);
      EXPECT_NEAR(std::hypot(point.arm.x, point.arm.y), 0.15, 0.006);
      middle = {middle.x + at.x, middle.y + at.y};
    }
    const Vector n = normal(segment, beam);
    EXPECT_NEAR(dot(n, middle) / std::hypot(middle.x, middle.y), -1.0, 1e-3);
  }
}

TEST(LiningSurface, EndsSegmentsAtCorners) {
  const Lining box = box_lining();
  const Beam beam(shape_of(box), box.section);
  const LiningSurface surface(box, beam, 0.5);
  EXPECT_EQ(surface.segments().size(), 24U);
  for (const SurfaceSegment& segment : surface.segments()) {
    EXPECT_NEAR(segment.length, 0.5, 1e-12);
    const Vector n = normal(segment, beam);
    EXPECT_NEAR(std::max(std::abs(n.x), std::abs(n.y)), 1.0, 1e-12);
  }
  EXPECT_NEAR(beam.position(0).x, -1.85, 1e-12); // half of the thickness behind both faces
  EXPECT_NEAR(beam.position(0).y, -0.85, 1e-12);
}

TEST(LiningSurface, PassesRigidMotionOnExactlyAndMomentsBack) {
  const Lining ring = ring_lining();
  const Beam beam(shape_of(ring), ring.section);
  const LiningSurface surface(ring, beam, 0.5);
  std::vector<double> v(beam.positions().size(), 0.7); // rad/s
  for (std::size_t k = 0; k < beam.node_count(); ++k) {
    v[beam.first_dof(k)] = 1.0 - 0.7 * beam.position(k).y;
    v[beam.first_dof(k) + 1] = -2.0 + 0.7 * beam.position(k).x;
  }
  const Lattice lattice{.h = 0.5, .x0 = -5.13, .y0 = -5.21, .nx = 22, .ny = 22, .first = 0};
  const std::vector<double> mass(lattice.count(), 1.0);
  const std::vector<SegmentRows> rows = find_rows(surface, beam, lattice, mass, 1.0);
  ASSERT_EQ(rows.size(), 40U);
  for (const SegmentRows& of : rows) {
    const Vector velocity = beam_velocity(of, v);
    EXPECT_NEAR(velocity.x, 1.0 - 0.7 * of.position.y, 1e-12);
    EXPECT_NEAR(velocity.y, -2.0 + 0.7 * of.position.x, 1e-12);
    double share = 0.0;
    Vector at{};
    for (const auto& [node, of_node] : of.soil) {
      share += of_node;
      at = {at.x + of_node * (lattice.x0 + static_cast<double>(node % 22) * 0.5),
            at.y + of_node * (lattice.y0 + static_cast<double>(node / 22) * 0.5)};
    }
    EXPECT_NEAR(share, 1.0, 1e-14);
    EXPECT_NEAR(at.x, of.position.x, 1e-14); // both sides act at the same position
    EXPECT_NEAR(at.y, of.position.y, 1e-14);
  }
}

TEST(LiningSurface, LeavesOutSegmentsWithoutSoil) {
  const Lining ring = ring_lining();
  const Beam beam(shape_of(ring), ring.section);
  const LiningSurface surface(ring, beam, 0.5);
  const Lattice lattice{.h = 0.5, .x0 = -5.0, .y0 = -5.0, .nx = 21, .ny = 21, .first = 0};
  std::vector<double> mass(lattice.count(), 1.0);
  for (std::size_t node = 0; node < mass.size() / 2; ++node)
    mass[node] = 0.0; // below y = 0
  const std::vector<SegmentRows> rows = find_rows(surface, beam, lattice, mass, 1.0);
  EXPECT_LT(rows.size(), 24U);
  for (const SegmentRows& of : rows) {
    EXPECT_GT(of.position.y, -0.5);
    for (const NodeShare& of_node : of.soil)
      EXPECT_GT(mass[of_node.node], 0.0);
  }
}

TEST(LiningSurface, CountsNodesByTheirMassWhileSoilBarelyReachesThem) {
  const Lining ring = ring_lining();
  const Beam beam(shape_of(ring), ring.section);
  const LiningSurface surface(ring, beam, 0.5);
  const Lattice lattice{.h = 0.5, .x0 = -5.13, .y0 = -5.21, .nx = 22, .ny = 22, .first = 0};
  const auto outside = [&](std::size_t node) {
    return std::hypot(lattice.x0 + static_cast<double>(node % 22) * 0.5,
                      lattice.y0 + static_cast<double>(node / 22) * 0.5) > 3.15;
  };
  std::vector<double> mass(lattice.count(), 0.0);
  for (std::size_t node = 0; node < mass.size(); ++node)
    mass[node] = outside(node) ? 1.0 : 0.0;
  const std::vector<SegmentRows> without = find_rows(surface, beam, lattice, mass, 1.0);
  std::ranges::replace(mass, 0.0, 1e-9);
  const std::vector<SegmentRows> with = find_rows(surface, beam, lattice, mass, 1.0);
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t k = 0; k < with.size(); ++k) {
    EXPECT_NEAR(with[k].position.x, without[k].position.x, 1e-6);
    EXPECT_NEAR(with[k].position.y, without[k].position.y, 1e-6);
    double answer = 0.0; // of nodes within the ring, to an impulse
    for (const auto& [node, share] : with[k].soil)
      if (!outside(node))
        answer += share * share / mass[node];
    EXPECT_LT(answer, 0.01); // of that of a node full of soil
  }
}

TEST(LiningSurface, RefusesOutlinesThatAreNone) {
  Lining clockwise = box_lining();
  std::ranges::reverse(clockwise.outline);
  EXPECT_THROW(shape_of(clockwise), std::invalid_argument);
  Lining thick = box_lining();
  thick.thickness = 2.1;
  EXPECT_THROW(shape_of(thick), std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
