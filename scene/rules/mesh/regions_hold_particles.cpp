#include "scene/plan/levels.hpp"
#include "scene/rules/particle_positions.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void regions_hold_particles(const Case& scene, Findings& findings) {
  if (!mesh_is_sound(scene, findings) || !findings.sound("mesh.particles_per_cell"))
    return;
  const mesh::Quadtree tree = quadtree(scene);
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    const Polygon& polygon = scene.regions[i].polygon;
    const auto path = scene.regions[i].path + ".polygon";
    if (!findings.sound(path) || polygon.empty())
      continue;
    const auto [left, right] = std::ranges::minmax(polygon, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax(polygon, {}, &Point::y);
    if (!find_particle_position(
            scene, tree, {left.x, low.y, right.x, high.y},
            [&polygon](const ParticlePosition& place) { return contains(polygon, place.middle); }))
      findings.add(
          path, fmt::format("'polygon' holds no particle, so its soil would not be there: particles lie in "
                            "the middle of squares of {} m, or less where the mesh is refined; take smaller "
                            "cells or a larger region",
                            scene.mesh.particle_size()));
  }
}

} // namespace tremolo::scene
