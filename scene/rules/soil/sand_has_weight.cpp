#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace tremolo::scene {

namespace {

/// Whether a soil lies in the domain, or in a free field that starts from the stress of its weight.
bool stands_under_weight(const Case& scene, std::size_t soil) {
  if (std::ranges::find(scene.regions, soil, &Region::soil) != scene.regions.end())
    return true;
  const auto& [sides, left, right, base] = scene.boundary;
  return std::ranges::any_of(std::array{&left, &right}, [&](const LateralBoundary* side) {
    return traits(side->field.model).effective_stress &&
           std::ranges::find(layers(scene, *side), std::optional(soil), &Layer::soil) !=
               layers(scene, *side).end();
  });
}

} // namespace

void sand_has_weight(const Case& scene, Findings& findings) {
  if (scene.gravity || !findings.sound("stage") || !findings.sound("region"))
    return;
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    const Soil& soil = scene.soils[i];
    const auto path = fmt::format("soil.{}.model", soil.name);
    if (materials::traits(soil.law).follows_pressure && stands_under_weight(scene, i) && findings.sound(path))
      findings.add(
          path,
          fmt::format("model = \"{}\" begins with the stress that gravity makes, without which it has no "
                      "stiffness: add a [[stage]] of kind = \"gravity\"",
                      materials::name(soil.law)));
  }
}

} // namespace tremolo::scene
