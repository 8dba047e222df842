// The normals that contact finds at nodes: along an edge at any angle to the grid they are those of the edge,
// and next to a corner they lie between those of its edges.

#include "mpm_domain/contact/contact_nodes.hpp"
#include "mpm_domain/domain.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

constexpr double h = 0.5;    // m
constexpr double side = 6.0; // of a square body buried in soil, m
constexpr double density = 2000.0;

/// Angles between the normals at nodes and that of the edge they lie next to; nearer than two cells to a
/// corner, to the cone between the normals of its edges. Degrees.
struct Errors {
  double flat = 0.0;   ///< the largest
  double corner = 0.0; ///< the largest
};

/// @param ratio  of the body's density to the soil's
Errors errors(double degrees, double ratio) {
  const double angle = degrees * std::numbers::pi / 180.0;
  Spec spec = flat_ground(24.0, 16.0, h, {density, 1e8, 0.3});
  spec.structures = {
      structure(turned(rectangle(-0.5 * side, -8.0 - 0.5 * side, 0.5 * side, -8.0 + 0.5 * side),
                       {0.03, -8.0 + 0.07}, angle),
                ratio * density, 0.4)};
  Domain domain(spec);
  scatter(domain, ScatterPart::both);
  const RigidBody& body = domain.contact.bodies().front();
  ContactNodes contact;
  contact.follow_sort(domain, body.surface(), 4.0);
  contact.find(domain, body.surface(), body.centre(), spec.structures.front(), nullptr);
  Errors found;
  for (const ContactNode& c : contact.nodes()) {
    const auto in_body = [&](const Vector& v) {
      return Vector{std::cos(angle) * v.x + std::sin(angle) * v.y,
                    std::cos(angle) * v.y - std::sin(angle) * v.x};
    };
    // In the frame of the body, at the corner where x and y are positive.
    Vector d = in_body(body.arm(c.position));
    Vector n = in_body(c.normal);
    n = {d.x < 0.0 ? n.x : -n.x, d.y < 0.0 ? n.y : -n.y};
    d = {std::abs(d.x), std::abs(d.y)};
    const double turn =
        std::atan2(n.y, n.x) * 180.0 / std::numbers::pi; // from the normal of the edge along y
    if (std::min(d.x, d.y) > 0.5 * side - 2.0 * h) {
      found.corner = std::max({found.corner, -turn, turn - 90.0});
      continue;
    }
    found.flat = std::max(found.flat, std::abs(turn - (d.x > d.y ? 0.0 : 90.0)));
  }
  return found;
}

TEST(Normals, AreThoseOfTheSurfaceAtAnyAngleToTheGrid) {
  for (double degrees = 0.0; degrees <= 90.0; degrees += 5.0)
    for (const double ratio : {1.0 / 6.0, 1e3}) {
      const Errors found = errors(degrees, ratio);
      EXPECT_LT(found.flat, 1e-5) << degrees;
      EXPECT_LT(found.corner, 1e-5) << degrees;
    }
}

} // namespace
} // namespace tremolo::mpm_domain
