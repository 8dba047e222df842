#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

void check_line(const std::string& path, const Outline& line, Findings& findings) {
  if (line.corners.empty())
    return;
  if (intersects_itself(line.corners))
    findings.add(path, fmt::format("'{}' crosses or touches itself: list the corners in order around the "
                                   "structure, each once",
                                   line.key));
  else if (!(area(line.corners) > 0.0))
    findings.add(path, fmt::format("'{}' has no area", line.key));
}

} // namespace

void structures_are_simple(const Case& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    const Structure& structure = scene.structures[i];
    check_line(outline_path(scene, i), structure.outline, findings);
    if (!structure.hole)
      continue;
    const std::string path = fmt::format("{}.{}", structure.path, structure.hole->key);
    check_line(path, *structure.hole, findings);
    if (outline_is_sound(scene, i, findings) && !structure.hole->corners.empty() && findings.sound(path) &&
        !encloses(structure.outline.corners, structure.hole->corners))
      findings.add(path, fmt::format("'{}' reaches beyond the outline, '{}': the hole must lie inside",
                                     structure.hole->key, structure.outline.key));
  }
}

} // namespace tremolo::scene
