#include "mpm_domain/contact/body_surface.hpp"

#include "mesh/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::mpm_domain {

BodySurface::BodySurface(std::vector<Vector> points, std::vector<bool> corner)
    : points_(std::move(points)), corner_(std::move(corner)) {}

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
    const Vector edge{points_[i].x - a.x, points_[i].y - a.y};
    const Vector from_a{place.x - a.x, place.y - a.y};
    const double length2 = dot(edge, edge);
    const double along = dot(from_a, edge) / length2;
    const double t = std::clamp(along, 0.0, 1.0);
    const Vector to{from_a.x - t * edge.x, from_a.y - t * edge.y};
    const double distance2 = dot(to, to);
    if (distance2 < least) {
      least = distance2;
      away = to;
      at_end = t != along;
      corner = at_end && corner_[along < 0.0 ? j : i];
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

} // namespace tremolo::mpm_domain
