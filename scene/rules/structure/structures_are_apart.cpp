#include "scene/meeting_boxes.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void structures_are_apart(const Case& scene, Findings& findings) {
  std::vector<std::size_t> usable;
  std::vector<Polygon> polygons;
  for (std::size_t i = 0; i < scene.structures.size(); ++i)
    if (outline_is_sound(scene, i, findings)) {
      usable.push_back(i);
      polygons.push_back(scene.structures[i].outline.corners);
    }
  for (const auto& [first, second] : overlaps(polygons)) {
    const std::size_t i = usable[second];
    findings.add(outline_path(scene, i),
                 fmt::format("'{}' overlaps the structure in line {}: structures may touch but not overlap",
                             scene.structures[i].outline.key,
                             findings.place(outline_path(scene, usable[first])).line));
  }
}

} // namespace tremolo::scene
