#pragma once

// Area, centroid and second moment of polygons, and their parts beside lines. With corners (x_i, y_i) and
// c_i = x_i y_{i+1} - x_{i+1} y_i, Green's theorem gives
//
//     A = 1/2 sum c_i,      A x_c = 1/6 sum c_i (x_i + x_{i+1}),
//     I_0 = 1/12 sum c_i (x_i^2 + x_i x_{i+1} + x_{i+1}^2 + the same in y),      I_c = I_0 - A |x_c|^2.
//
// Polygons are vectors of corners with members x and y; the last is joined to the first.

#include <cstddef>
#include <utility>

namespace tremolo::mesh {

struct PolygonMeasures {
  double area = 0.0; ///< m2, >= 0
  double x = 0.0;    ///< of the centroid, m
  double y = 0.0;
  double polar = 0.0; ///< second moment about the centroid, m4
};

/// Twice the area, positive where corners run counter-clockwise, m2.
template <class Polygon>
double signed_double_area(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    sum += polygon[j].x * polygon[i].y - polygon[i].x * polygon[j].y;
  return sum;
}

template <class Polygon>
PolygonMeasures measures(const Polygon& polygon) {
  PolygonMeasures m;
  if (polygon.empty())
    return m;
  const double x0 = polygon.front().x; // sums about a corner: nothing cancels far from the origin
  const double y0 = polygon.front().y;
  double area = 0.0;
  double first_x = 0.0;
  double first_y = 0.0;
  double second = 0.0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const double ax = polygon[j].x - x0;
    const double ay = polygon[j].y - y0;
    const double bx = polygon[i].x - x0;
    const double by = polygon[i].y - y0;
    const double c = ax * by - bx * ay;
    area += c / 2.0;
    first_x += c * (ax + bx) / 6.0;
    first_y += c * (ay + by) / 6.0;
    second += c * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12.0;
  }
  if (area == 0.0)
    return {0.0, x0, y0, 0.0};
  const double cx = first_x / area;
  const double cy = first_y / area;
  const double sense = area < 0.0 ? -1.0 : 1.0;
  return {sense * area, x0 + cx, y0 + cy, sense * (second - area * (cx * cx + cy * cy))};
}

/// The part of a polygon on one side of a line, where side(corner) >= 0 (Sutherland and Hodgman 1974). A
/// polygon that is not convex may keep edges along the line, which enclose nothing.
template <class Polygon, class Side>
Polygon clipped(const Polygon& polygon, const Side& side) {
  Polygon kept;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const auto& a = polygon[j];
    const auto& b = polygon[i];
    const double of_a = side(a);
    const double of_b = side(b);
    if ((of_a >= 0.0) != (of_b >= 0.0)) {
      const double t = of_a / (of_a - of_b);
      kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    if (of_b >= 0.0)
      kept.push_back(b);
  }
  return kept;
}

/// The part of a polygon below a level (m).
template <class Polygon>
Polygon part_below(const Polygon& polygon, double level) {
  return clipped(polygon, [&](const auto& corner) { return level - corner.y; });
}

} // namespace tremolo::mesh
