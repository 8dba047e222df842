#include "scene/plan/levels.hpp"
#include "scene/rules/particle_positions.hpp"
#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/run/places_in_soil.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

namespace {

/// Whether the soil that a polygon holds is at least one particle.
bool holds_soil(const Case& scene, const mesh::Quadtree& tree, const Polygon& polygon) {
  const auto [left, right] = std::ranges::minmax(polygon, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(polygon, {}, &Point::y);
  return find_particle_position(scene, tree, {left.x, low.y, right.x, high.y},
                                [&](const ParticlePosition& place) {
                                  return contains(polygon, place.particle) && in_soil(scene, place.middle);
                                });
}

} // namespace

void sliding_masses_hold_soil(const Case& scene, Findings& findings) {
  check_result_names("sliding_mass", scene.sliding_masses, findings);
  for (std::size_t i = 0; i < scene.sliding_masses.size(); ++i) {
    const Outline& outline = scene.sliding_masses[i].outline;
    const std::string path = fmt::format("sliding_mass[{}].{}", i, outline.key);
    if (outline.corners.empty() || !findings.sound(path))
      continue;
    if (intersects_itself(outline.corners))
      findings.add(path,
                   fmt::format("'{}' crosses or touches itself: list the corners in order around the sliding "
                               "mass, each once",
                               outline.key));
    else if (mesh_is_sound(scene, findings) && findings.sound("mesh.particles_per_cell") &&
             findings.sound("region") && !holds_soil(scene, quadtree(scene), outline.corners))
      findings.add(path, fmt::format("'{}' holds no particle of soil at the start", outline.key));
  }
}

} // namespace tremolo::scene
