#include "scene/rules/rules.hpp"
#include "scene/soils/plausible.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void values_are_in_si_units(const Case& scene, Findings& findings) {
  for (const auto& [path, doubt] : unit_doubts(scene.values))
    findings.add(path, doubt);
  // A profile over depth may go to zero at the surface: its largest value says in which unit it is.
  for (const SoilProfile& profile : scene.soil_profiles)
    for (const VaryingKey& key : profile.keys) {
      const Soil& soil = scene.soils[profile.first];
      const std::string path = fmt::format("soil.{}.{}", soil.name, key.key);
      if (const auto doubt = unit_doubt(path, std::ranges::max(key.values), materials::name(soil.law)))
        findings.add(path, *doubt);
    }
}

} // namespace tremolo::scene
