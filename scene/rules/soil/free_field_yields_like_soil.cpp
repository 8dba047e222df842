#include "mesh/cell_size.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/wave/arrival.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tremolo::scene {

namespace {

bool is_linear(const materials::Law& law) {
  return materials::traits(law).response == materials::Response::elastic;
}

/// Whether the side's field is that of linear soil. The ground behind a recording or a user's program is
/// unknown.
bool is_linear(const Case& scene, const LateralBoundary& side) {
  const FreeFieldTraits& model = traits(side.field.model);
  if (model.from_outside)
    return false;
  return model.soil == SoilTreatment::linear ||
         std::ranges::none_of(layers(scene, side), [&](const Layer& layer) {
           return layer.soil && !is_linear(scene.soils[*layer.soil].law);
         });
}

/// The softest nonlinear soil whose regions reach the edge at x, nullptr if there is none.
const Soil* soil_that_yields(const Case& scene, double x) {
  const double near = mesh::alignment_tolerance(scene.mesh.size);
  const Soil* softest = nullptr;
  for (const Region& region : scene.regions) {
    const bool there = std::ranges::any_of(region.polygon, [&](Point p) { return std::abs(p.x - x) < near; });
    const auto impedance = [](const Soil& one) {
      const auto& elastic = materials::elasticity(one.law);
      return elastic.density * elastic.s_wave_speed();
    };
    for (const std::size_t s : soils_of(region))
      if (const Soil& soil = scene.soils[s];
          there && !is_linear(soil.law) && (softest == nullptr || impedance(soil) < impedance(*softest)))
        softest = &soil;
  }
  return softest;
}

} // namespace

void free_field_yields_like_soil(const Case& scene, Findings& findings) {
  if (!scene.boundary.has_lateral_fields())
    return;
  const auto& box = scene.mesh.box;
  for (const auto& [side, name, x] : {std::tuple(&scene.boundary.left, "left", box.x_min),
                                      std::tuple(&scene.boundary.right, "right", box.x_max)}) {
    const Soil* soil = soil_that_yields(scene, x);
    if (soil == nullptr || !is_linear(scene, *side))
      continue;
    const auto& elastic = materials::elasticity(soil->law);
    // Incident and reflected wave add up to twice the incident one's stress at most.
    const double stress = 2.0 * elastic.density * elastic.s_wave_speed() * incident_peak_velocity(scene);
    findings.add(
        fmt::format("boundary.{}.model", name),
        fmt::format("the free field is elastic, the soil '{}' beside it is not: the side shakes it with "
                    "shear stresses of the order of {:.3g} kPa, whether or not the soil can carry them; a "
                    "column (\"fe\", \"mpm\") whose layers name the soil yields with it",
                    soil->name, 1e-3 * stress));
  }
}

} // namespace tremolo::scene
