#include "scene/geometry.hpp"

#include "mesh/polygon.hpp"
#include "scene/meeting_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace tremolo::scene {

namespace {

struct Segment {
  Point a;
  Point b;
};

Segment edge(const Polygon& polygon, std::size_t i) {
  return {polygon[i], polygon[(i + 1) % polygon.size()]};
}

double length(Point a) {
  return std::hypot(a.x, a.y);
}

/// Distances below this fraction of a segment's length count as zero: corners typed as decimals meet exactly
/// on paper.
constexpr double tolerance = 1e-9;

bool on_segment(Point p, const Segment& s) {
  const Point along = s.b - s.a;
  const Point to = p - s.a;
  const double size = length(along);
  if (size == 0.0)
    return length(to) == 0.0;
  const double t = dot(to, along) / (size * size);
  return t >= -tolerance && t <= 1.0 + tolerance && std::abs(cross(along, to)) <= tolerance * size * size;
}

bool on_outline(const Polygon& polygon, Point p) {
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (on_segment(p, edge(polygon, i)))
      return true;
  return false;
}

/// Parameters in [0, 1] along s where it meets the segment other, for segments that are not parallel.
void add_crossing(const Segment& s, const Segment& other, std::vector<double>& cuts) {
  const Point d = s.b - s.a;
  const Point e = other.b - other.a;
  const double denominator = cross(d, e);
  if (std::abs(denominator) <= tolerance * length(d) * length(e))
    return;
  const double t = cross(other.a - s.a, e) / denominator;
  if (t > 0.0 && t < 1.0)
    cuts.push_back(t);
}

bool segments_meet(const Segment& s, const Segment& r) {
  if (on_segment(s.a, r) || on_segment(s.b, r) || on_segment(r.a, s) || on_segment(r.b, s))
    return true;
  const auto side = [](const Segment& line, Point p) { return cross(line.b - line.a, p - line.a) > 0.0; };
  return side(s, r.a) != side(s, r.b) && side(r, s.a) != side(r, s.b);
}

Box box_of(const Segment& s) {
  return scene::box_of(std::vector{s.a, s.b});
}

/// Whether a piece of a's edge, cut where it meets the edges of b, runs inside b.
bool edge_enters(const Polygon& a, const Polygon& b) {
  const Box all = scene::box_of(b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Segment s = edge(a, i);
    if (!meet(box_of(s), all))
      continue;
    std::vector<double> cuts = {0.0, 1.0};
    for (std::size_t j = 0; j < b.size(); ++j)
      add_crossing(s, edge(b, j), cuts);
    std::ranges::sort(cuts);
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      const double t = 0.5 * (cuts[k - 1] + cuts[k]);
      if (cuts[k] - cuts[k - 1] > tolerance &&
          strictly_inside(b, {s.a.x + t * (s.b.x - s.a.x), s.a.y + t * (s.b.y - s.a.y)}))
        return true;
    }
  }
  return false;
}

/// A point inside a simple polygon: the middle of the first span of a horizontal line between two corners'
/// levels.
Point inner_point(const Polygon& polygon) {
  std::vector<double> levels;
  for (const Point p : polygon)
    levels.push_back(p.y);
  std::ranges::sort(levels);
  const auto above = std::ranges::find_if(levels, [&](double y) { return y > levels.front(); });
  if (above == levels.end())
    return polygon.front();
  const double y = 0.5 * (levels.front() + *above);
  std::vector<double> crossings;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto [a, b] = edge(polygon, i);
    if ((a.y > y) != (b.y > y))
      crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  std::ranges::sort(crossings);
  return crossings.size() < 2 ? polygon.front() : Point{0.5 * (crossings[0] + crossings[1]), y};
}

} // namespace

// n triangles of two sides R and an angle a between them: n/2 R^2 sin a = pi r^2.
Polygon circle(Point centre, double radius) {
  constexpr int corners = 64;
  constexpr double angle = 2.0 * std::numbers::pi / corners;
  const double reach = radius * std::sqrt(angle / std::sin(angle));
  Polygon polygon;
  for (int k = 0; k < corners; ++k)
    polygon.push_back({centre.x + reach * std::cos(angle * k), centre.y + reach * std::sin(angle * k)});
  return polygon;
}

std::vector<Point> points_along(Point from, Point to, double spacing) {
  constexpr double rounding = 1e-9;
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const auto pieces = static_cast<int>(std::ceil(length / spacing - rounding));
  std::vector<Point> points;
  for (int k = 0; k <= pieces; ++k) {
    const double share = pieces > 0 ? static_cast<double>(k) / pieces : 0.0;
    points.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
  }
  return points;
}

double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(edge(polygon, i).a - polygon.front(), edge(polygon, i).b - polygon.front());
  return 0.5 * std::abs(twice);
}

double perimeter(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += length(edge(polygon, i).b - edge(polygon, i).a);
  return sum;
}

void for_pieces(const Polygon& polygon, double level, double longest,
                const std::function<void(Point from, Point to)>& visit) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto [a, b] = edge(polygon, i);
    if (a.y > level && b.y > level)
      continue;
    const auto at = [a = a, b = b](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
    const double crossing = a.y > level || b.y > level ? (level - a.y) / (b.y - a.y) : 0.0;
    const double begin = a.y > level ? crossing : 0.0;
    const double end = b.y > level ? crossing : 1.0;
    const int parts = std::max(1, static_cast<int>(std::ceil(length(at(end) - at(begin)) / longest)));
    const auto part = [=](double n) { return at(begin + n / parts * (end - begin)); };
    for (int n = 0; n < parts; ++n)
      visit(part(n), part(n + 1));
  }
}

bool contains(const Polygon& polygon, Point p) {
  return on_outline(polygon, p) || mesh::inside(polygon, p.x, p.y);
}

bool strictly_inside(const Polygon& polygon, Point p) {
  return !on_outline(polygon, p) && mesh::inside(polygon, p.x, p.y);
}

bool intersects_itself(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  std::vector<Box> boxes;
  boxes.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Segment s = edge(polygon, i);
    const Segment next = edge(polygon, (i + 1) % n);
    if (length(s.b - s.a) == 0.0 || on_segment(next.b, s) || on_segment(s.a, next))
      return true;
    boxes.push_back(box_of(s));
  }
  return for_each_meeting_pair(boxes, [&](std::size_t i, std::size_t j) {
    const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
    return !neighbours && segments_meet(edge(polygon, i), edge(polygon, j));
  });
}

bool encloses(const Polygon& outer, const Polygon& inner) {
  for (std::size_t i = 0; i < inner.size(); ++i)
    for (std::size_t j = 0; j < outer.size(); ++j)
      if (segments_meet(edge(inner, i), edge(outer, j)))
        return false;
  return strictly_inside(outer, inner.front());
}

// If no edge of either runs inside the other, the interiors are equal or disjoint; one inner point shows
// which.
bool overlap(const Polygon& a, const Polygon& b) {
  return meet(box_of(a), box_of(b)) &&
         (edge_enters(a, b) || edge_enters(b, a) || strictly_inside(b, inner_point(a)));
}

} // namespace tremolo::scene
