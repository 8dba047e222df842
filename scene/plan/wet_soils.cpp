#include "scene/plan/wet_soils.hpp"

#include "scene/plan/layers.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/ground_column.hpp"
#include "scene/soils/water_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::scene {

namespace {

bool in_layer_below(double surface, double table, const std::vector<Layer>& layers, std::size_t soil) {
  double bottom = surface;
  return std::ranges::any_of(layers, [&](const Layer& layer) {
    bottom -= layer.thickness;
    return layer.soil == soil && bottom < table;
  });
}

/// Whether a region reaches below the table: a corner of it, or its lower edge below a corner of the line.
bool reaches_below_table(const Case& scene, const Region& region) {
  const auto below = [&](double x, double y) { return y < highest_table_at(scene, x); };
  return std::ranges::any_of(region.polygon, [&](Point corner) { return below(corner.x, corner.y); }) ||
         std::ranges::any_of(scene.water->line, [&](Point corner) {
           const std::vector<double> levels = crossings(region.polygon, corner.x);
           return !levels.empty() && below(corner.x, levels.back());
         });
}

bool in_region_below(const Case& scene, std::size_t soil) {
  return std::ranges::any_of(scene.regions, [&](const Region& region) {
    const std::vector<std::size_t> there = soils_of(region);
    const std::size_t slice = soil - region.soil;
    return std::ranges::find(there, soil) != there.end() &&
           (slice == region.cuts.size() || region.cuts[slice] < scene.water->highest()) &&
           reaches_below_table(scene, region);
  });
}

/// A text on a choice of drainage and the time that it saves.
std::string_view drainage_text(materials::Drainage drainage) {
  switch (drainage) {
  case materials::Drainage::coupled:
    return "water flows by Darcy's law";
  case materials::Drainage::undrained:
    return "water moves with the grains: no second velocity";
  case materials::Drainage::drained:
    return "water keeps the pressure of undisturbed water: no second velocity, no pore pressure";
  }
  return {};
}

/// A text on the meaning of a phreatic line: for flow along a slope beta, p = gamma_w z cos^2 beta below it.
std::string line_text(const Case& scene) {
  const Polygon& line = scene.water->line;
  double steepest = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    steepest = std::max(steepest, std::abs((line[i].y - line[i - 1].y) / (line[i].x - line[i - 1].x)));
  if (steepest == 0.0)
    return {};
  return fmt::format(
      "  the line is hydrostatic straight below, which is no flow: where it is steepest ({:.3g} "
      "degrees), pressures are {:.3g} % higher than those of flow along it, and nothing balances "
      "its force across; seepage = true finds the flow\n",
      std::atan(steepest) * 180.0 / std::numbers::pi, 100.0 * steepest * steepest);
}

/// Whether water stands over the ground of the domain: at a corner of its surface, or at a side.
bool has_free_water(const Case& scene) {
  const Box& box = scene.mesh.box;
  const double inside = 1e-6 * box.width();
  const auto stands_at = [&](double x, double table) {
    const GroundColumn ground = ground_of_domain(scene, x);
    return !ground.empty() && ground.front().top < table - 1e-6 * box.height();
  };
  if (stands_at(box.x_min + inside, scene.water->beside(Side::left)) ||
      stands_at(box.x_max - inside, scene.water->beside(Side::right)))
    return true;
  return !scene.water->seepage && std::ranges::any_of(scene.regions, [&](const Region& region) {
    return std::ranges::any_of(region.polygon, [&](Point corner) {
      return corner.x > box.x_min && corner.x < box.x_max && stands_at(corner.x, table_at(scene, corner.x));
    });
  });
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
    if (in_region_below(scene, i) ||
        in_layer_below(scene.surface_level, scene.water->beside(Side::left, scene.surface_level),
                       scene.profile, i) ||
        in_layer_below(left.surface, left.water_level, layers(scene, left), i) ||
        in_layer_below(right.surface, right.water_level, layers(scene, right), i))
      soils.emplace_back(scene.soils[i]);
  return soils;
}

bool lets_water_flow(const Soil& soil) {
  return soil.pores && soil.pores->drainage == materials::Drainage::coupled;
}

std::string table_text(const GroundWater& water) {
  if (water.seepage)
    return fmt::format("water seeps from y = {} m at the left to y = {} m at the right", water.seepage->left,
                       water.seepage->right);
  return water.line.empty() ? fmt::format("water table at y = {} m", water.level)
                            : fmt::format("phreatic line from y = {} m at the left to y = {} m at the right",
                                          water.line.front().y, water.line.back().y);
}

std::string water_text(const Case& scene) {
  const auto soils = soils_below_table(scene);
  if (soils.empty())
    return fmt::format("{}, below all soil\n", table_text(*scene.water));
  std::string text =
      fmt::format("{}; models other than \"fe\" and \"mpm\" take the ground below it as undrained; soil "
                  "there:\n",
                  table_text(*scene.water));
  for (const Soil& soil : one_of_each_name(soils))
    text += soil_text(soil, scene.water->fluid, scene.gravity.value_or(GravityStage{}).acceleration);
  text += line_text(scene);
  if (has_free_water(scene))
    text += "  free water over the ground presses on it as at rest; what it adds to the inertia in the "
            "shaking is "
            "left out\n";
  return text;
}

} // namespace tremolo::scene
