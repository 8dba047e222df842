#include "scene/soils/ground_column.hpp"

#include "scene/plan/layers.hpp"
#include "scene/soils/water_table.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tremolo::scene {

namespace {

constexpr double dry = -std::numeric_limits<double>::infinity(); ///< level of a table without water, m

/// Densities for the effective stress above and below the water table, kg/m3.
std::pair<double, double> densities_of(const GroundPiece& piece, const Case& scene) {
  const auto* soil = piece.soil ? &scene.soils[*piece.soil] : nullptr;
  if (soil != nullptr && soil->pores)
    return {materials::dry_density(*soil->pores),
            materials::buoyant_density(*soil->pores, scene.water->fluid)};
  const double density = piece.elastic.density;
  return {density, scene.water ? density - scene.water->fluid.density : density};
}

} // namespace

std::vector<double> crossings(const Polygon& polygon, double x) {
  std::vector<double> levels;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point a = polygon[j];
    const Point b = polygon[i];
    if ((a.x > x) != (b.x > x))
      levels.push_back(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
  }
  std::ranges::sort(levels, std::greater{});
  return levels;
}

GroundColumn ground_of_layers(const Case& scene, double surface, double table,
                              const std::vector<Layer>& layers, double down_to) {
  GroundColumn ground;
  if (!scene.water)
    table = dry;
  for (const Layer& layer : layers) {
    ground.push_back({surface, surface - layer.thickness, layer.soil,
                      layer.soil ? materials::elasticity(scene.soils[*layer.soil].law) : layer.elastic,
                      table});
    surface -= layer.thickness;
  }
  if (down_to < surface)
    ground.push_back({surface, down_to, std::nullopt, scene.halfspace, table});
  return ground;
}

GroundColumn ground_of_free_field(const Case& scene, const LateralBoundary& side) {
  return ground_of_layers(scene, side.surface, side.water_level, layers(scene, side), scene.mesh.box.y_min);
}

GroundColumn ground_of_domain(const Case& scene, double x) {
  GroundColumn ground;
  const double table = scene.water ? std::max(table_at(scene, x), scene.water->still_wet.value_or(dry)) : dry;
  for (const Region& region : scene.regions) {
    const std::vector<double> levels = crossings(region.polygon, x);
    for (std::size_t i = 0; i + 1 < levels.size(); i += 2) {
      double top = levels[i];
      const auto add = [&](double bottom) {
        const std::size_t soil = region.soil_at(0.5 * (top + bottom));
        ground.push_back({top, bottom, soil, materials::elasticity(scene.soils[soil].law), table});
        top = bottom;
      };
      for (const double cut : region.cuts)
        if (cut < top && cut > levels[i + 1])
          add(cut);
      add(levels[i + 1]);
    }
  }
  std::ranges::sort(ground, std::greater{}, &GroundPiece::top);
  return ground;
}

double vertical_stress(const Case& scene, const GroundColumn& ground, double y) {
  double mass = 0.0; // per area, kg/m2
  for (const GroundPiece& piece : ground) {
    if (piece.top <= y)
      break;
    const double bottom = std::max(piece.bottom, y);
    const double split = std::clamp(piece.table, bottom, piece.top);
    const auto [above, below] = densities_of(piece, scene);
    mass += above * (piece.top - split) + below * (split - bottom);
  }
  return scene.gravity.value_or(GravityStage{}).acceleration * mass;
}

} // namespace tremolo::scene
