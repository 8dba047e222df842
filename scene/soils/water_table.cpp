#include "scene/soils/water_table.hpp"

#include "mpm_domain/spec/on_line.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

double table_at(const Case& scene, double x) {
  const GroundWater& water = *scene.water;
  if (!water.line.empty())
    return mpm_domain::on_line(water.line, x).level;
  if (!water.seepage)
    return water.level;
  const Box& box = scene.mesh.box;
  return std::lerp(water.seepage->left, water.seepage->right,
                   std::clamp((x - box.x_min) / box.width(), 0.0, 1.0));
}

double highest_table_at(const Case& scene, double x) {
  const GroundWater& water = *scene.water;
  return water.seepage || water.still_wet ? water.highest() : table_at(scene, x);
}

} // namespace tremolo::scene
