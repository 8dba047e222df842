#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include "mesh/polygon_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::scene {

namespace {

/// How far a ray from p along d (of length 1) runs to the first edge that it meets, m.
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

/// The least way through a polygon from the middle of an edge, at right angles to it, m.
double thickness(const Polygon& polygon) {
  const double sense = mesh::signed_double_area(polygon) > 0.0 ? 1.0 : -1.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point a = polygon[j];
    const Point b = polygon[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Point inward{-sense * (b.y - a.y) / length, sense * (b.x - a.x) / length};
    // A little off the edge itself, which is no way through.
    const double off = 1e-6 * length;
    const Point middle{0.5 * (a.x + b.x) + off * inward.x, 0.5 * (a.y + b.y) + off * inward.y};
    least = std::min(least, off + free_way(polygon, middle, inward));
  }
  return least;
}

} // namespace

void structures_are_wide(const Case& scene, Findings& findings) {
  if (!mesh_is_sound(scene, findings))
    return;
  constexpr double enough = 1.99; // cells: the flats of a circle's polygon lie a little inside it
  const double h = contact_cell_size(scene);
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    if (!outline_is_sound(scene, i, findings))
      continue;
    const Outline& outline = scene.structures[i].outline;
    const double wide = thickness(outline.corners);
    if (wide < enough * h)
      findings.add(
          outline_path(scene, i),
          fmt::format("'{}' is {:.3g} m thick at one place, must be at least two cells of {:g} m: soil "
                      "on one side would meet that on the other; take a thicker structure or smaller "
                      "cells",
                      outline.key, wide, h));
  }
}

} // namespace tremolo::scene
