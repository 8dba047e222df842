#include "scene/soils/level_ground.hpp"

#include "scene/soils/ground_column.hpp"

namespace tremolo::scene {

std::optional<double> level_ground_stress(const Case& scene, double y) {
  if (y > scene.surface_level)
    return std::nullopt;
  const GroundColumn ground =
      ground_of_layers(scene, scene.surface_level, scene.water ? scene.water->level : 0.0, scene.profile, y);
  return vertical_stress(scene, ground, y);
}

} // namespace tremolo::scene
