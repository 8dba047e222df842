#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void resting_sand_is_shaken_first(const Case& scene, Findings& findings) {
  if (scene.fastest_rest() == nullptr)
    return;
  for (const Soil& soil : scene.soils) {
    const auto parameters = materials::parameters(soil.law);
    const auto shaken = std::ranges::find(parameters, "post_shake", &materials::ParameterValue::name);
    if (shaken != parameters.end() && shaken->value == 1.0)
      findings.add(fmt::format("soil.{}.post_shake", soil.name),
                   fmt::format("'post_shake' = true gives soil '{}' the stiffness of sand that has been "
                               "shaken from the first step on, and the rest gives it this stiffness when "
                               "it begins: remove the key",
                               soil.name));
  }
}

} // namespace tremolo::scene
