#include "scene/plan/wet_soils.hpp"

#include "scene/plan/layers.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::scene {

namespace {

bool in_layer_below(const Case& scene, double surface, const std::vector<Layer>& layers, std::size_t soil) {
  double bottom = surface;
  return std::ranges::any_of(layers, [&](const Layer& layer) {
    bottom -= layer.thickness;
    return layer.soil == soil && bottom < scene.water->level;
  });
}

bool in_region_below(const Case& scene, std::size_t soil) {
  return std::ranges::any_of(scene.regions, [&](const Region& region) {
    const std::vector<std::size_t> there = soils_of(region);
    const std::size_t slice = soil - region.soil;
    return std::ranges::find(there, soil) != there.end() &&
           (slice == region.cuts.size() || region.cuts[slice] < scene.water->level) &&
           std::ranges::any_of(region.polygon, [&](Point corner) { return corner.y < scene.water->level; });
  });
}

/// What a choice of drainage means, and what it saves.
std::string_view drainage_text(materials::Drainage drainage) {
  switch (drainage) {
  case materials::Drainage::coupled:
    return "water flows by Darcy's law";
  case materials::Drainage::undrained:
    return "water moves with the grains: no second velocity";
  case materials::Drainage::drained:
    return "water stays hydrostatic: no second velocity, no pore pressure";
  }
  return {};
}

std::string soil_text(const Soil& soil, const materials::PoreFluid& fluid, double gravity) {
  const materials::PoreSpace& pores = *soil.pores;
  const auto& skeleton = materials::elasticity(soil.law);
  std::string text =
      fmt::format("  {:<18}{}, {}\n"
                  "    density    {:.5g} kg/m3 saturated, {:.5g} dry, {:.5g} buoyant; porosity {:.4g}, void "
                  "ratio {:.4g}\n",
                  soil.name, name(pores.drainage), drainage_text(pores.drainage),
                  materials::saturated_density(pores, fluid), materials::dry_density(pores),
                  materials::buoyant_density(pores, fluid), pores.porosity, pores.void_ratio());
  if (pores.drainage == materials::Drainage::drained)
    return text;
  const double m = skeleton.p_modulus();
  const auto speeds = materials::saturated_speeds(m, pores, fluid);
  const auto undrained = materials::saturated(skeleton, pores, fluid);
  const double shear_speed = undrained.s_wave_speed();
  text += fmt::format(
      "    stiffness  water K_f/n = {:.3g} Pa, {:.3g} times that of the skeleton\n"
      "    waves      c_u = {:.4g} m/s undrained, c_s = {:.4g} m/s, critical angle of SV {:.2f} degrees\n",
      materials::pore_stiffness(pores, fluid), materials::pore_stiffness(pores, fluid) / m, speeds.undrained,
      shear_speed, std::asin(shear_speed / speeds.undrained) * 180.0 / std::numbers::pi);
  if (pores.drainage == materials::Drainage::coupled)
    text +=
        fmt::format("    drag       k = {:g} m/s: {:.3g} 1/s; c_1 = {:.4g} m/s and c_2 = {:.4g} m/s without "
                    "it; c_v = {:.3g} m2/s\n",
                    pores.permeability, materials::drag_rate(pores, fluid, gravity), speeds.fast, speeds.slow,
                    materials::consolidation_coefficient(m, pores, fluid, gravity));
  return text;
}

} // namespace

std::vector<std::reference_wrapper<const Soil>> soils_below_table(const Case& scene) {
  std::vector<std::reference_wrapper<const Soil>> soils;
  if (!scene.water)
    return soils;
  const auto& [sides, left, right, base] = scene.boundary;
  for (std::size_t i = 0; i < scene.soils.size(); ++i)
    if (in_region_below(scene, i) || in_layer_below(scene, scene.surface_level, scene.profile, i) ||
        in_layer_below(scene, left.surface, layers(scene, left), i) ||
        in_layer_below(scene, right.surface, layers(scene, right), i))
      soils.emplace_back(scene.soils[i]);
  return soils;
}

bool lets_water_flow(const Soil& soil) {
  return soil.pores && soil.pores->drainage == materials::Drainage::coupled;
}

std::string water_text(const Case& scene) {
  const auto soils = soils_below_table(scene);
  if (soils.empty())
    return fmt::format("water table at y = {} m, below all soil\n", scene.water->level);
  std::string text =
      fmt::format("water table at y = {} m; models other than \"fe\" and \"mpm\" take the ground below it "
                  "as undrained; soil there:\n",
                  scene.water->level);
  for (const Soil& soil : one_of_each_name(soils))
    text += soil_text(soil, scene.water->fluid, scene.gravity.value_or(GravityStage{}).acceleration);
  return text;
}

} // namespace tremolo::scene
