#include "scene/plan/rest/fast_rest.hpp"

#include "scene/plan/layers.hpp"
#include "scene/plan/wet_soils.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

/// H, m
double wet_depth(const Case& scene) {
  const double base =
      scene.mesh.size > 0.0 ? scene.mesh.box.y_min : base_level(scene.surface_level, scene.profile);
  return std::min(scene.water->level, scene.surface_level) - base;
}

} // namespace

double FastRest::settlement_error() const {
  return 0.8 * std::pow(slow_wave, 1.5);
}

std::optional<FastRest> fast_rest(const Case& scene) {
  if (!scene.rest || scene.rest->time_factor == 1.0 || !scene.water || !scene.gravity)
    return std::nullopt;
  const double factor = scene.rest->time_factor;
  const double depth = wet_depth(scene);
  std::optional<FastRest> fast;
  for (const Soil& soil : soils_below_table(scene)) {
    if (!soil.pores || soil.pores->drainage != materials::Drainage::coupled)
      continue;
    const double m = materials::elasticity(soil.law).p_modulus();
    const double rho = materials::saturated_density(*soil.pores, scene.water->fluid);
    const double unit_weight = scene.water->fluid.density * scene.gravity->acceleration;
    const double flow = factor * soil.pores->permeability;
    const double c_u = materials::saturated_speeds(m, *soil.pores, scene.water->fluid).undrained;
    FastRest& largest = fast ? *fast : fast.emplace();
    largest.slow_wave = std::max(largest.slow_wave, flow * std::sqrt(m * rho) / (unit_weight * depth));
    largest.permeability = std::max(largest.permeability, flow);
    largest.ringing = std::max(largest.ringing, 4.0 * depth / c_u);
  }
  return fast;
}

} // namespace tremolo::scene
