#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

std::string outline_path(const Case& scene, std::size_t structure) {
  return fmt::format("{}.{}", scene.structures[structure].path, scene.structures[structure].outline.key);
}

bool outline_is_sound(const Case& scene, std::size_t structure, const Findings& findings) {
  return !scene.structures[structure].outline.corners.empty() &&
         findings.sound(outline_path(scene, structure));
}

} // namespace tremolo::scene
