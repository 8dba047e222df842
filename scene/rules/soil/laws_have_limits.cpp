#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void laws_have_limits(const Case& scene, Findings& findings) {
  for (const Soil& soil : scene.soils)
    for (const std::string& limit : materials::notes(soil.law))
      findings.add("soil." + soil.name, fmt::format("soil '{}': {}", soil.name, limit));
}

} // namespace tremolo::scene
