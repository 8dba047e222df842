#include "scene/plan/rest/fast_rest.hpp"

#include "scene/plan/layers.hpp"
#include "scene/plan/wet_soils.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::scene {

namespace {

struct Extent {
  double bottom = 0.0; ///< y, m
  double top = 0.0;
};

/// Ground below the table, from the lowest to the highest point of what `counts`, in regions and layers.
template <typename Counts>
Extent extent_below_table(const Case& scene, const Counts& counts) {
  Extent extent{scene.water->highest(), -std::numeric_limits<double>::infinity()};
  const auto add = [&](double bottom, double top) {
    if (bottom >= scene.water->highest())
      return;
    extent.bottom = std::min(extent.bottom, bottom);
    extent.top = std::max(extent.top, std::min(top, scene.water->highest()));
  };
  for (const Region& region : scene.regions)
    if (counts(scene.soils[region.soil])) {
      const auto [low, high] = std::ranges::minmax(region.polygon, {}, &Point::y);
      add(low.y, high.y);
    }
  for (const LateralBoundary* side : {&scene.boundary.left, &scene.boundary.right}) {
    double top = side->surface;
    for (const Layer& layer : layers(scene, *side)) {
      if (layer.soil && counts(scene.soils[*layer.soil]))
        add(top - layer.thickness, top);
      top -= layer.thickness;
    }
  }
  return extent;
}

double height(const Extent& extent) {
  return extent.top - extent.bottom;
}

} // namespace

double FastRest::settlement_error() const {
  return 0.8 * std::pow(slow_wave, 1.5);
}

std::optional<FastRest> fast_rest(const Case& scene) {
  const TimedStage* const stage = scene.fastest_rest();
  if (stage == nullptr || stage->rest->time_factor == 1.0 || !scene.water || !scene.gravity)
    return std::nullopt;
  const double depth = height(extent_below_table(scene, [](const Soil&) { return true; }));
  const double drained = height(extent_below_table(scene, lets_water_flow));
  std::optional<FastRest> fast;
  double stiffest = 0.0; // sqrt(M rho)
  for (const Soil& soil : soils_below_table(scene)) {
    if (!lets_water_flow(soil))
      continue;
    const double m = materials::elasticity(soil.law).p_modulus();
    const double flow = stage->rest->time_factor * soil.pores->permeability;
    FastRest& worst = fast ? *fast : fast.emplace();
    if (flow > worst.permeability) {
      worst.permeability = flow;
      worst.most_permeable = soil.name;
    }
    stiffest =
        std::max(stiffest, std::sqrt(m * materials::saturated_density(*soil.pores, scene.water->fluid)));
    worst.ringing =
        std::max(worst.ringing,
                 4.0 * depth / materials::saturated_speeds(m, *soil.pores, scene.water->fluid).undrained);
  }
  if (fast)
    fast->slow_wave =
        fast->permeability * stiffest / (scene.water->fluid.density * scene.gravity->acceleration * drained);
  return fast;
}

} // namespace tremolo::scene
