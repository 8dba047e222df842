#include "scene/plan/free_field_traits.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace tremolo::scene {

namespace {

/// A soil of the domain for which reduced dispersion has not been validated; null if there is none.
const Soil* unsuited_soil(const Case& scene) {
  for (const Soil& soil : domain_soils(scene)) {
    const materials::Response response = materials::traits(soil.law).response;
    if (response != materials::Response::elastic && response != materials::Response::hysteretic)
      return &*std::ranges::find(scene.soils, soil.name, &Soil::name);
  }
  return nullptr;
}

bool has_column_of_cells(const Case& scene) {
  const auto& [sides, left, right, base] = scene.boundary;
  return std::ranges::any_of(std::array{left.field.model, right.field.model, base.field.model},
                             [](SourceModel model) { return traits(model).of_domain_cells; });
}

} // namespace

void dispersion_suits_case(const Case& scene, Findings& findings) {
  if (scene.mesh.dispersion != Dispersion::reduced || !findings.sound("mesh.dispersion"))
    return;
  const auto refuse = [&](std::string_view why) {
    findings.add("mesh.dispersion", fmt::format("'dispersion' = \"reduced\" {}", why));
  };
  if (has_column_of_cells(scene))
    refuse("needs a free field other than \"mpm\", whose levels read their velocities as means over nodes");
  if (findings.sound("soil"))
    if (const Soil* soil = unsuited_soil(scene))
      refuse(fmt::format("is for elastic and hysteretic soil: slopes that yield, as soil '{}' may, fail "
                         "seconds early with it",
                         soil->name));
}

} // namespace tremolo::scene
