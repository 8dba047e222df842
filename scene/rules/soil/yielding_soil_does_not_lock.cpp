#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

/// Above it cells that yield without a change of volume become too strong.
constexpr double largest_poisson = 0.45;

} // namespace

void yielding_soil_does_not_lock(const Case& scene, Findings& findings) {
  if (scene.mesh.dilatation == Dilatation::cell)
    return;
  for (const Soil& soil : domain_soils(scene)) {
    const double poisson = materials::elasticity(soil.law).poisson;
    if (poisson > largest_poisson && materials::traits(soil.law).response != materials::Response::elastic)
      findings.add(
          "soil." + soil.name,
          fmt::format("soil '{}': Poisson's ratio {:.3g} is above {}, the soil can yield, and [mesh] "
                      "dilatation = \"particle\": its cells lock and carry more than the soil, at 0.495 a "
                      "slope in undrained clay nearly twice its limit load; use \"cell\" (docs/theory.md)",
                      soil.name, poisson, largest_poisson));
  }
}

} // namespace tremolo::scene
