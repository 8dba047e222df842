#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

constexpr double densest_dry_soil = 1900.0; // kg/m3: quartz sand of porosity 0.28
constexpr double slowest_rock = 760.0;      // m/s
constexpr double water = 1000.0;            // kg/m3

} // namespace

void saturated_soil_has_water(const Case& scene, Findings& findings) {
  if (!scene.gravity || scene.water)
    return;
  for (const Soil& soil : domain_soils(scene)) {
    const auto& elastic = materials::elasticity(soil.law);
    if (elastic.density > densest_dry_soil && elastic.s_wave_speed() < slowest_rock)
      findings.add(
          "soil." + soil.name + ".density",
          fmt::format(
              "soil '{}': {} kg/m3 is the density of saturated soil, but the domain has no water: all of "
              "the weight is effective stress, {:.2g} times that under a water table at the surface, and "
              "no pore pressure rises",
              soil.name, elastic.density, elastic.density / (elastic.density - water)));
  }
}

} // namespace tremolo::scene
