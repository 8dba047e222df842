#include "mpm_domain/contact/body_surface.hpp"

#include "mesh/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Sine of the angle by which an outline turns at a corner, at least.
const double least_turn = std::sin(20.0 * std::numbers::pi / 180.0);
/// Cosine of the angle within which an edge faces a direction.
const double least_facing = std::sqrt(0.5);

} // namespace

BodySurface::BodySurface(std::vector<Vector> points) : points_(std::move(points)), kinds_(points_.size()) {
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Vector to = normal_of_edge_to(k);
    const Vector from = normal_of_edge_to((k + 1) % points_.size());
    const double turn = cross(to, from);
    if (std::abs(turn) > least_turn || dot(to, from) < 0.0)
      kinds_[k] = turn > 0.0 ? Point::toe : Point::inner_corner;
  }
}

Vector BodySurface::normal_of_edge_to(std::size_t k) const {
  const Vector from = points_[before(k)];
  const Vector edge = points_[k] - from;
  const double per_length = 1.0 / std::hypot(edge.x, edge.y);
  return {edge.y * per_length, -edge.x * per_length};
}

mesh::Rectangle BodySurface::bounds() const {
  mesh::Rectangle box{points_.front().x, points_.front().y, points_.front().x, points_.front().y};
  for (const Vector& point : points_)
    box = {std::min(box.x_min, point.x), std::min(box.y_min, point.y), std::max(box.x_max, point.x),
           std::max(box.y_max, point.y)};
  return box;
}

bool BodySurface::contains(const Vector& place) const {
  return mesh::inside(points_, place.x, place.y);
}

BodySurface::Nearest BodySurface::nearest(const Vector& place) const {
  double least = std::numeric_limits<double>::infinity();
  Vector away{};        // from the surface to the place
  Vector edge_normal{}; // of the edge that it belongs to
  bool at_end = false;
  bool corner = false;
  for (std::size_t i = 0, j = points_.size() - 1; i < points_.size(); j = i++) {
    const Vector a = points_[j];
    const Vector edge = points_[i] - a;
    const Vector from_a = place - a;
    const double length2 = dot(edge, edge);
    const double along = dot(from_a, edge) / length2;
    const double t = std::clamp(along, 0.0, 1.0);
    const Vector to = from_a - t * edge;
    const double distance2 = dot(to, to);
    if (distance2 < least) {
      least = distance2;
      away = to;
      at_end = t != along;
      corner = at_end && kinds_[along < 0.0 ? j : i] != Point::round;
      const double per_length = 1.0 / std::sqrt(length2);
      edge_normal = {edge.y * per_length, -edge.x * per_length};
    }
  }
  const double distance = std::sqrt(least);
  const double sense = contains(place) ? -1.0 : 1.0;
  if (!at_end || distance == 0.0)
    return {sense * distance, edge_normal, corner};
  return {sense * distance, {sense * away.x / distance, sense * away.y / distance}, corner};
}

bool BodySurface::faces(const Vector& normal, const Vector& direction) {
  return dot(normal, direction) >= least_facing;
}

std::optional<BodySurface::Foot> BodySurface::foot(const Vector& place, const Vector& direction) const {
  std::optional<Foot> found;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (!faces(normal_of_edge_to(k), direction))
      continue;
    const Vector a = points_[before(k)];
    const Vector edge = points_[k] - a;
    const double along = dot(place - a, edge) / dot(edge, edge);
    const double t = std::clamp(along, 0.0, 1.0);
    const Vector foot = a + t * edge;
    const double distance2 = square(place - foot);
    if (distance2 < least) {
      least = distance2;
      found = Foot{foot, t != along && kinds_[along < 0.0 ? before(k) : k] == Point::toe};
    }
  }
  return found;
}

std::vector<BodySurface::Toe> BodySurface::toes() const {
  std::vector<Toe> toes;
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (kinds_[k] == Point::toe)
      toes.push_back({points_[k], {normal_of_edge_to(k), normal_of_edge_to((k + 1) % points_.size())}});
  return toes;
}

mesh::Rectangle widened(const mesh::Rectangle& box, double margin) {
  return {box.x_min - margin, box.y_min - margin, box.x_max + margin, box.y_max + margin};
}

} // namespace tremolo::mpm_domain
