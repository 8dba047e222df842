#include "mpm_domain/contact/impulses/collisions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Change of a body's motion by a unit impulse along a direction at an arm.
RigidMotion answer(const Response& r, const Vector& direction, const Vector& arm) {
  const double turn = cross(arm, direction);
  const auto row = [&](std::size_t i) {
    return r[3 * i] * direction.x + r[3 * i + 1] * direction.y + r[3 * i + 2] * turn;
  };
  return {{row(0), row(1)}, row(2)};
}

void add(RigidMotion& to, const RigidMotion& change, double factor) {
  to.velocity.x += factor * change.velocity.x;
  to.velocity.y += factor * change.velocity.y;
  to.spin += factor * change.spin;
}

/// A face that a corner may touch: its normal, out of the body that it belongs to, and how far outside of it
/// the corner lies, m.
struct Touched {
  Vector normal;
  double gap;
};

/// Whether a body lies on the outer side of a face that its corner touches, up to some tilt.
bool lies_outside(const Vector& before, const Vector& corner, const Vector& after, const Vector& normal) {
  constexpr double tilt = 0.1;
  return std::ranges::all_of(std::array{before, after}, [&](const Vector& next) {
    const Vector edge = next - corner;
    return dot(edge, normal) >= -tilt * std::sqrt(square(edge));
  });
}

/// The face of a body that a corner of another, between two of its points, touches within a distance. Where
/// corners meet the nearest point has a normal that may belong to a face along which the other body passes:
/// then it is the nearest of the faces beside that point which the other body lies outside of, if any.
std::optional<Touched> touched_face(const BodySurface& surface, const Vector& before, const Vector& corner,
                                    const Vector& after, double distance) {
  const BodySurface::Nearest nearest = surface.nearest(corner);
  if (nearest.distance >= distance)
    return std::nullopt;
  if (lies_outside(before, corner, after, nearest.normal))
    return Touched{nearest.normal, nearest.distance};
  std::optional<Touched> found;
  for (const BodySurface::Toe& toe : surface.toes())
    for (const Vector& normal : toe.normals) {
      const Vector off = corner - toe.position;
      const double gap = dot(off, normal);
      if (square(off) < distance * distance && lies_outside(before, corner, after, normal) &&
          (!found || std::abs(gap) < std::abs(found->gap)))
        found = Touched{normal, gap};
    }
  return found;
}

void find_corners(std::span<const RigidBody> bodies, std::size_t owner, std::size_t other, double friction,
                  double distance, std::vector<CornerContact>& corners) {
  const mesh::Rectangle box = bodies[other].surface().bounds();
  const std::vector<Vector>& outline = bodies[owner].outline();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector& corner = outline[k];
    if (corner.x < box.x_min - distance || corner.x > box.x_max + distance ||
        corner.y < box.y_min - distance || corner.y > box.y_max + distance)
      continue;
    const auto face =
        touched_face(bodies[other].surface(), outline[(k + outline.size() - 1) % outline.size()], corner,
                     outline[(k + 1) % outline.size()], distance);
    if (!face)
      continue;
    CornerContact& found = corners.emplace_back();
    found.a = other; // the normal out of it points to the owner of the corner
    found.b = owner;
    found.arm_a = bodies[other].arm(corner);
    found.arm_b = bodies[owner].arm(corner);
    found.normal = face->normal;
    found.gap = face->gap;
    found.friction = friction;
  }
}

} // namespace

std::vector<CornerContact> find_corners(std::span<const RigidBody> bodies,
                                        std::span<const Structure> structures, double distance) {
  std::vector<CornerContact> corners;
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      if (structures[a].stiffness || structures[b].stiffness)
        continue; // meets at nodes
      const double of_both = std::min(structures[a].friction_between, structures[b].friction_between);
      find_corners(bodies, a, b, of_both, distance, corners);
      find_corners(bodies, b, a, of_both, distance, corners);
    }
  return corners;
}

double resolve(std::span<CornerContact> corners, std::span<RigidMotion> motions,
               std::span<const Response> responses, double dt) {
  constexpr int sweeps = 200;
  double most = 0.0;
  std::vector<std::pair<double, double>> before;
  for (const CornerContact& c : corners)
    before.emplace_back(c.normal_impulse, c.tangential_impulse);
  for (int k = 0; k < sweeps; ++k) {
    double change = 0.0;
    double scale = 0.0;
    for (CornerContact& c : corners) {
      const Vector tangent{-c.normal.y, c.normal.x};
      // One direction; returns by how much the impulse changes.
      const auto push = [&](const Vector& direction, double wanted_speed, double impulse, double low,
                            double high) {
        const RigidMotion of_a = answer(responses[c.a], direction, c.arm_a);
        const RigidMotion of_b = answer(responses[c.b], direction, c.arm_b);
        const double soft = dot(direction, of_a.at(c.arm_a)) + dot(direction, of_b.at(c.arm_b));
        const double speed =
            dot(direction, motions[c.b].at(c.arm_b)) - dot(direction, motions[c.a].at(c.arm_a));
        const double after = std::clamp(impulse + (wanted_speed - speed) / soft, low, high);
        add(motions[c.a], of_a, impulse - after);
        add(motions[c.b], of_b, after - impulse);
        change = std::max(change, std::abs(after - impulse));
        scale = std::max(scale, std::abs(after));
        return after;
      };
      c.normal_impulse = push(c.normal, -std::max(0.0, c.gap) / dt, c.normal_impulse, 0.0,
                              std::numeric_limits<double>::max());
      const double limit = c.friction * c.normal_impulse;
      c.tangential_impulse = push(tangent, 0.0, c.tangential_impulse, -limit, limit);
    }
    if (change <= 1e-13 * scale)
      break;
  }
  for (std::size_t n = 0; n < corners.size(); ++n)
    most = std::max({most, std::abs(corners[n].normal_impulse - before[n].first),
                     std::abs(corners[n].tangential_impulse - before[n].second)});
  return most;
}

} // namespace tremolo::mpm_domain
