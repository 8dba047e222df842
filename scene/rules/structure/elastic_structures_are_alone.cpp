#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::scene {

namespace {

/// The least distance of a corner of one polygon from the edges of another, m.
double corner_distance(const Polygon& corners, const Polygon& edges) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point p : corners)
    for (std::size_t i = 0, j = edges.size() - 1; i < edges.size(); j = i++) {
      const Point a = edges[j];
      const Point along{edges[i].x - a.x, edges[i].y - a.y};
      const double t = std::clamp(((p.x - a.x) * along.x + (p.y - a.y) * along.y) /
                                      (along.x * along.x + along.y * along.y),
                                  0.0, 1.0);
      least = std::min(least, std::hypot(p.x - a.x - t * along.x, p.y - a.y - t * along.y));
    }
  return least;
}

} // namespace

void elastic_structures_are_alone(const Case& scene, Findings& findings) {
  if (!mesh_is_sound(scene, findings))
    return;
  const double h = contact_cell_size(scene);
  for (std::size_t i = 0; i < scene.structures.size(); ++i)
    for (std::size_t other = 0; other < i; ++other) {
      const Structure& a = scene.structures[other];
      const Structure& b = scene.structures[i];
      if ((!a.stiffness && !b.stiffness) || !outline_is_sound(scene, i, findings) ||
          !outline_is_sound(scene, other, findings))
        continue;
      const double distance = std::min(corner_distance(a.outline.corners, b.outline.corners),
                                       corner_distance(b.outline.corners, a.outline.corners));
      if (distance < h)
        findings.add(outline_path(scene, i),
                     fmt::format("'{}' is {:.3g} m from the structure in line {}, must be at least a cell of "
                                 "{:g} m: elastic structures touch soil alone; make both rigid, or one "
                                 "structure of them",
                                 b.outline.key, distance, findings.place(outline_path(scene, other)).line,
                                 h));
    }
}

} // namespace tremolo::scene
