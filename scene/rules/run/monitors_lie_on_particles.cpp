#include "scene/plan/levels.hpp"
#include "scene/rules/particle_positions.hpp"
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

/// The particle that starts nearest to a point, sought in wider and wider squares around it.
Nearest nearest_particle(const Case& scene, const mesh::Quadtree& tree, Point point) {
  const Box& box = scene.mesh.box;
  const double all = std::hypot(box.x_max - box.x_min, box.y_max - box.y_min);
  Nearest best;
  for (double reach = scene.mesh.size; best.distance > 0.5 * reach && reach < 4.0 * all; reach *= 2.0)
    find_particle_position(scene, tree, {point.x - reach, point.y - reach, point.x + reach, point.y + reach},
                           [&](const ParticlePosition& place) {
                             const Point at = place.particle;
                             const double distance = std::hypot(at.x - point.x, at.y - point.y);
                             if (distance < best.distance &&
                                 std::ranges::any_of(scene.regions, [&](const Region& r) {
                                   return contains(r.polygon, place.middle);
                                 }))
                               best = {at, distance};
                             return false; // look at all
                           });
  return best;
}

} // namespace

void monitors_lie_on_particles(const Case& scene, Findings& findings) {
  if (scene.monitors.empty())
    return;
  const mesh::Quadtree tree = quadtree(scene);
  for (std::size_t i = 0; i < scene.monitors.size(); ++i) {
    const auto& [name, point, structure] = scene.monitors[i];
    if (structure)
      continue;
    const Nearest best = nearest_particle(scene, tree, point);
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
