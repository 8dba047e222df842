#include "scene/plan/lining/beam_outline.hpp"

#include "mesh/polygon_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::scene {

namespace {

constexpr double least_elements = 64.0;
/// A hinge takes a corner that is nearer than this part of an element.
constexpr double near = 0.1;

double distance(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

Point between(Point a, Point b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

struct OnEdge {
  std::size_t edge = 0;
  Point position;
};

OnEdge nearest_edge(const Polygon& polygon, Point to) {
  OnEdge nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < polygon.size(); ++e) {
    const Point a = polygon[e];
    const Point b = polygon[(e + 1) % polygon.size()];
    const Point along{b.x - a.x, b.y - a.y};
    const double length2 = along.x * along.x + along.y * along.y;
    const double share =
        length2 > 0.0 ? std::clamp(((to.x - a.x) * along.x + (to.y - a.y) * along.y) / length2, 0.0, 1.0)
                      : 0.0;
    const Point position = between(a, b, share);
    if (const double d = distance(position, to); d < least) {
      least = d;
      nearest = {e, position};
    }
  }
  return nearest;
}

/// A corner that stays, and whether it is a hinge.
struct Mark {
  Point position;
  bool hinge = false;
};

/// Makes a hinge of the corner beside a position of the outline, or adds a corner there.
void add_hinge(std::vector<Mark>& marks, Point at, double element) {
  Polygon corners;
  for (const Mark& mark : marks)
    corners.push_back(mark.position);
  const OnEdge on = nearest_edge(corners, at);
  for (const std::size_t end : {on.edge, (on.edge + 1) % marks.size()})
    if (distance(marks[end].position, on.position) < near * element) {
      marks[end].hinge = true;
      return;
    }
  marks.insert(marks.begin() + static_cast<std::ptrdiff_t>(on.edge) + 1, Mark{on.position, true});
}

} // namespace

BeamOutline beam_outline(const Lining& lining, double cell_size) {
  Polygon outline = lining.outline.corners;
  if (mesh::signed_double_area(outline) < 0.0)
    std::ranges::reverse(outline);
  const double longest = std::min(cell_size, perimeter(outline) / least_elements);
  std::vector<Mark> marks;
  for (const Point corner : outline)
    marks.push_back({corner});
  for (const Point hinge : lining.hinges)
    add_hinge(marks, hinge, longest);
  BeamOutline beam;
  for (std::size_t m = 0; m < marks.size(); ++m) {
    const Point a = marks[m].position;
    const Point b = marks[(m + 1) % marks.size()].position;
    if (marks[m].hinge)
      beam.hinges.push_back(beam.corners.size());
    constexpr double rounding = 1e-6;
    const double pieces = std::max(1.0, std::ceil(distance(a, b) / longest - rounding));
    for (double k = 0.0; k < pieces; ++k)
      beam.corners.push_back(between(a, b, k / pieces));
  }
  return beam;
}

Point nearest_on(const Polygon& polygon, Point to) {
  return nearest_edge(polygon, to).position;
}

} // namespace tremolo::scene
