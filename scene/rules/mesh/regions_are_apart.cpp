#include "scene/meeting_boxes.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <vector>

namespace tremolo::scene {

void regions_are_apart(const Case& scene, Findings& findings) {
  const auto path = [&](std::size_t region) { return scene.regions[region].path + ".polygon"; };
  // A polygon that crosses itself, or has no area, has been reported.
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < scene.regions.size(); ++i)
    if (!scene.regions[i].polygon.empty() && findings.sound(path(i)))
      usable.push_back(i);
  std::vector<Polygon> polygons;
  for (const std::size_t i : usable)
    polygons.push_back(scene.regions[i].polygon);
  for (const auto& [first, second] : overlaps(polygons))
    findings.add(path(usable[second]),
                 fmt::format("'polygon' overlaps the one in line {}: regions may touch but not overlap",
                             findings.place(path(usable[first])).line));
}

} // namespace tremolo::scene
