#include "scene/soils/level_ground.hpp"

#include "scene/soils/ground_column.hpp"

namespace tremolo::scene {

std::optional<double> level_ground_stress(const Case& scene, double y) {
  if (y > scene.surface_level)
    return std::nullopt;
  const double surface = scene.surface_level;
  const double table = scene.water ? scene.water->beside(Side::left, surface) : 0.0;
  const GroundColumn ground = ground_of_layers(scene, surface, table, scene.profile, y);
  return vertical_stress(scene, ground, y);
}

} // namespace tremolo::scene
