// sigma'_v(y) = g int_y^surface rho' dy, with rho' the density of dry soil above the water table and the
// buoyant one, rho - rho_w, below it (Terzaghi 1943, Theoretical soil mechanics).

#include "scene/soils/level_ground.hpp"

#include <algorithm>
#include <limits>

namespace tremolo::scene {

namespace {

/// What carries stress in the ground above and below the water table, kg/m3.
struct Densities {
  double above = 0.0;
  double below = 0.0;
};

Densities densities_of(double density, const Case& scene) {
  return {density, scene.water ? density - scene.water->fluid.density : density};
}

Densities densities_of(const Layer& layer, const Case& scene) {
  const auto* soil = layer.soil ? &scene.soils[*layer.soil] : nullptr;
  if (soil == nullptr || !soil->pores)
    return densities_of(layer.elastic.density, scene);
  return {materials::dry_density(*soil->pores), materials::buoyant_density(*soil->pores, scene.water->fluid)};
}

} // namespace

std::optional<double> level_ground_stress(const Case& scene, double y) {
  if (y > scene.surface_level)
    return std::nullopt;
  const double gravity = scene.gravity.value_or(GravityStage{}).acceleration;
  const double table = scene.water ? scene.water->level : -std::numeric_limits<double>::infinity();
  double mass = 0.0; // per area, kg/m2
  const auto add = [&](double top, double bottom, const Densities& densities) {
    const double split = std::clamp(table, bottom, top);
    mass += densities.above * (top - split) + densities.below * (split - bottom);
  };
  double top = scene.surface_level;
  for (const Layer& layer : scene.profile) {
    const double bottom = std::max(top - layer.thickness, y);
    add(top, bottom, densities_of(layer, scene));
    top = bottom;
    if (top <= y)
      return gravity * mass;
  }
  add(top, y, densities_of(scene.halfspace.density, scene));
  return gravity * mass;
}

} // namespace tremolo::scene
