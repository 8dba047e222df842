#include "mpm_domain/contact/body_surface.hpp"

#include "mesh/polygon.hpp"
#include "mpm_domain/particles/bounds.hpp"

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

BodySurface::BodySurface(std::vector<Vector> points) : kinds_(points.size()) {
  place(std::move(points));
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Vector& to = normals_[k];
    const Vector& from = normals_[(k + 1) % points_.size()];
    const double turn = cross(to, from);
    if (std::abs(turn) > least_turn || dot(to, from) < 0.0)
      kinds_[k] = turn > 0.0 ? Point::toe : Point::inner_corner;
  }
}

void BodySurface::place(std::vector<Vector> points) {
  points_ = std::move(points);
  normals_.resize(points_.size());
  edges_.resize((points_.size() + 3) / 4);
  bounds_ = around_nothing;
  for (std::size_t n = 0; n < 4 * edges_.size(); ++n) {
    const std::size_t k = std::min(n, points_.size() - 1);
    const Vector& to = points_[k];
    const Vector& from = points_[before(k)];
    const Vector edge = to - from;
    const double length2 = dot(edge, edge);
    const double per_length = 1.0 / std::sqrt(length2);
    normals_[k] = {edge.y * per_length, -edge.x * per_length};
    FourEdges& four = edges_[n / 4];
    four.from_x[n % 4] = from.x;
    four.from_y[n % 4] = from.y;
    four.x[n % 4] = edge.x;
    four.y[n % 4] = edge.y;
    four.per_length2[n % 4] = 1.0 / length2;
    reach_around(bounds_, to.x, to.y);
  }
}

bool BodySurface::contains(const Vector& position) const {
  return position.x >= bounds_.x_min && position.x <= bounds_.x_max && position.y >= bounds_.y_min &&
         position.y <= bounds_.y_max && mesh::inside(points_, position.x, position.y);
}

std::size_t BodySurface::nearest_edge(const Vector& position) const {
  Lanes least = all(std::numeric_limits<double>::infinity());
  Lanes four_of_least{};
  for (std::size_t four = 0; four < edges_.size(); ++four) {
    const FourEdges& e = edges_[four];
    const Lanes x = position.x - e.from_x;
    const Lanes y = position.y - e.from_y;
    const Lanes t = clamp((x * e.x + y * e.y) * e.per_length2, 0.0, 1.0);
    const Lanes to_x = x - t * e.x;
    const Lanes to_y = y - t * e.y;
    const Lanes distance2 = to_x * to_x + to_y * to_y;
    const LaneMask nearer = distance2 < least;
    least = choose(nearer, distance2, least);
    four_of_least = choose(nearer, all(static_cast<double>(four)), four_of_least);
  }
  std::size_t lane = 0;
  for (std::size_t other = 1; other < 4; ++other)
    if (least[other] < least[lane] ||
        (least[other] == least[lane] && four_of_least[other] < four_of_least[lane]))
      lane = other;
  return std::min(4 * static_cast<std::size_t>(four_of_least[lane]) + lane, points_.size() - 1);
}

BodySurface::Nearest BodySurface::nearest(const Vector& position) const {
  const std::size_t k = nearest_edge(position);
  const Vector& from = points_[before(k)];
  const Vector edge = points_[k] - from;
  const double along = dot(position - from, edge) / dot(edge, edge);
  const double t = std::clamp(along, 0.0, 1.0);
  const Vector away = position - from - t * edge;
  const double distance = std::sqrt(dot(away, away));
  if (t == along) // from within the edge, it shows on which side of it a point lies
    return {std::copysign(distance, dot(away, normals_[k])), normals_[k], false};
  const bool corner = kinds_[along < 0.0 ? before(k) : k] != Point::round;
  if (distance == 0.0)
    return {0.0, normals_[k], corner};
  const double sense = contains(position) ? -1.0 : 1.0;
  return {sense * distance, sense * away / distance, corner};
}

bool BodySurface::faces(const Vector& normal, const Vector& direction) {
  return dot(normal, direction) >= least_facing;
}

std::optional<BodySurface::Foot> BodySurface::foot(const Vector& position, const Vector& direction) const {
  std::optional<Foot> found;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (!faces(normals_[k], direction))
      continue;
    const Vector a = points_[before(k)];
    const Vector edge = points_[k] - a;
    const double along = dot(position - a, edge) / dot(edge, edge);
    const double t = std::clamp(along, 0.0, 1.0);
    const Vector foot = a + t * edge;
    const double distance2 = square(position - foot);
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
      toes.push_back({points_[k], {normals_[k], normals_[(k + 1) % points_.size()]}});
  return toes;
}

mesh::Rectangle widened(const mesh::Rectangle& box, double margin) {
  return {box.x_min - margin, box.y_min - margin, box.x_max + margin, box.y_max + margin};
}

} // namespace tremolo::mpm_domain
