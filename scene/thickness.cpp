#include "scene/thickness.hpp"

#include "mesh/polygon_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::scene {

namespace {

/// Distance along a ray from p in the unit direction d to the first edge, m.
double free_way(const Polygon& polygon, Point p, Point d) {
  double way = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point a{polygon[j].x - p.x, polygon[j].y - p.y};
    const Point e{polygon[i].x - polygon[j].x, polygon[i].y - polygon[j].y};
    const double denominator = d.x * e.y - d.y * e.x;
    if (denominator == 0.0)
      continue;
    const double t = (a.x * e.y - a.y * e.x) / denominator;
    const double s = (a.x * d.y - a.y * d.x) / denominator;
    if (t > 0.0 && s >= 0.0 && s <= 1.0)
      way = std::min(way, t);
  }
  return way;
}

/// The least way from the middle of an edge of `edges` to the edges of either polygon.
/// @param inward  1 into the polygon of these edges, -1 out of it
double least_way(const Polygon& edges, double inward, const Polygon& outline, const Polygon& hole) {
  const double sense = mesh::signed_double_area(edges) > 0.0 ? inward : -inward;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = edges.size() - 1; i < edges.size(); j = i++) {
    const Point a = edges[j];
    const Point b = edges[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Point across{-sense * (b.y - a.y) / length, sense * (b.x - a.x) / length};
    // A little off the edge itself, which is no way through.
    const double off = 1e-6 * length;
    const Point middle{0.5 * (a.x + b.x) + off * across.x, 0.5 * (a.y + b.y) + off * across.y};
    least = std::min({least, off + free_way(outline, middle, across), off + free_way(hole, middle, across)});
  }
  return least;
}

} // namespace

double thickness(const Polygon& outline, const Polygon& hole) {
  return std::min(least_way(outline, 1.0, outline, hole), least_way(hole, -1.0, outline, hole));
}

} // namespace tremolo::scene
