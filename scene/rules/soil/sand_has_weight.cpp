#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace tremolo::scene {

void sand_has_weight(const Case& scene, Findings& findings) {
  if (scene.gravity || !findings.sound("stage") || !findings.sound("region"))
    return;
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    const Soil& soil = scene.soils[i];
    const auto path = fmt::format("soil.{}.model", soil.name);
    if (materials::traits(soil.law).follows_pressure &&
        std::ranges::find(scene.regions, i, &Region::soil) != scene.regions.end() && findings.sound(path))
      findings.add(
          path,
          fmt::format("model = \"{}\" begins with the stress that gravity makes, without which it has no "
                      "stiffness: add a [[stage]] of kind = \"gravity\"",
                      materials::name(soil.law)));
  }
}

} // namespace tremolo::scene
