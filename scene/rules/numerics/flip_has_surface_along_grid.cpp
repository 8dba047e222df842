#include "mesh/cell_size.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

/// Whether soil on one side of the point and nothing on the other makes it part of a free surface.
bool is_free(const Case& scene, Point at, Point normal, double distance) {
  const auto soil_at = [&](double way) {
    const Point p{at.x + way * normal.x, at.y + way * normal.y};
    return std::ranges::any_of(scene.regions, [&](const Region& r) { return contains(r.polygon, p); });
  };
  return soil_at(distance) != soil_at(-distance);
}

/// Whether the edge from a to b runs along a line between cells.
bool is_on_line(const Case& scene, Point a, Point b) {
  const double size = scene.mesh.size;
  const auto on_line = [&](double from, double to, double origin) {
    const double cells = (from - origin) / size;
    return std::abs(to - from) < mesh::alignment_tolerance(size) &&
           std::abs(cells - std::round(cells)) < 1e-6;
  };
  return on_line(a.x, b.x, scene.mesh.box.x_min) || on_line(a.y, b.y, scene.mesh.box.y_min);
}

/// Whether a piece of the edge from a to b lies bare.
bool is_bare(const Case& scene, Point a, Point b) {
  const double size = scene.mesh.size;
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length = std::hypot(dx, dy);
  const Point normal{-dy / length, dx / length};
  const int pieces = static_cast<int>(std::min(std::ceil(length / size), 1000.0));
  for (int i = 0; i < pieces; ++i) {
    const double share = (i + 0.5) / pieces;
    if (is_free(scene, {a.x + share * dx, a.y + share * dy}, normal, 1e-3 * size))
      return true;
  }
  return false;
}

} // namespace

void flip_has_surface_along_grid(const Case& scene, Findings& findings) {
  if (scene.time.transfer != Transfer::flip || !findings.sound("time.transfer") ||
      !mesh_is_sound(scene, findings) || !findings.sound("region"))
    return;
  for (const Region& region : scene.regions)
    for (std::size_t i = 0; i < region.polygon.size(); ++i) {
      const Point a = region.polygon[i];
      const Point b = region.polygon[(i + 1) % region.polygon.size()];
      if (is_on_line(scene, a, b) || !is_bare(scene, a, b))
        continue;
      findings.add(
          "time.transfer",
          fmt::format(
              "'transfer' = \"flip\" with a free surface off the lines of the grid, from ({}, {}) to "
              "({}, {}): particles in cells that are not full start to ring, which FLIP never forgets; "
              "use \"apic\"",
              a.x, a.y, b.x, b.y));
      return;
    }
}

} // namespace tremolo::scene
