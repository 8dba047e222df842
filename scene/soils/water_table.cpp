#include "scene/soils/water_table.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

double on_line(const Polygon& line, double x) {
  const auto right = std::ranges::upper_bound(line, x, {}, &Point::x);
  if (right == line.begin())
    return line.front().y;
  if (right == line.end())
    return line.back().y;
  const Point& a = *(right - 1);
  return std::lerp(a.y, right->y, (x - a.x) / (right->x - a.x));
}

} // namespace

double table_at(const Case& scene, double x) {
  const GroundWater& water = *scene.water;
  if (!water.line.empty())
    return on_line(water.line, x);
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
