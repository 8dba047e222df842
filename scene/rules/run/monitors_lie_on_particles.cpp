#include "scene/plan/levels.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::scene {

namespace {

struct Nearest {
  Point place;
  double distance = std::numeric_limits<double>::infinity(); ///< m
};

/// The particle that starts nearest to a point, of those that fill the leaf, as the domain puts them there.
void look_in(const Case& scene, const mesh::Quadtree& tree, const mesh::Cell& leaf, Point point,
             Nearest& best) {
  const auto& cell = tree.rectangle(leaf);
  const double dx = std::max({cell.x_min - point.x, 0.0, point.x - cell.x_max});
  const double dy = std::max({cell.y_min - point.y, 0.0, point.y - cell.y_max});
  if (std::hypot(dx, dy) >= best.distance)
    return;
  const int n = scene.mesh.particles_per_cell;
  const double size = (cell.x_max - cell.x_min) / n;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Point place{cell.x_min + (i + 0.5) * size, cell.y_min + (j + 0.5) * size};
      const double distance = std::hypot(place.x - point.x, place.y - point.y);
      if (distance < best.distance &&
          std::ranges::any_of(scene.regions, [&](const Region& r) { return contains(r.polygon, place); }))
        best = {place, distance};
    }
}

} // namespace

void monitors_lie_on_particles(const Case& scene, Findings& findings) {
  if (scene.monitors.empty())
    return;
  const mesh::Quadtree tree = quadtree(scene);
  for (std::size_t i = 0; i < scene.monitors.size(); ++i) {
    const auto& [name, point] = scene.monitors[i];
    Nearest best;
    for (const mesh::Cell& leaf : tree.leaves())
      look_in(scene, tree, leaf, point, best);
    constexpr double rounding = 1e-9;
    if (best.distance > rounding * scene.mesh.size && std::isfinite(best.distance))
      findings.add(
          fmt::format("monitor[{}].point", i),
          fmt::format("monitor \"{}\" follows the particle that starts at [{:.6g}, {:.6g}], {:.3g} m from "
                      "its point",
                      name, best.place.x, best.place.y, best.distance));
  }
}

} // namespace tremolo::scene
