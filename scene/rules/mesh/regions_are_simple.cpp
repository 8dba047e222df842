#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void regions_are_simple(const Case& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    const Polygon& polygon = scene.regions[i].polygon;
    const std::string path = scene.regions[i].path + ".polygon";
    if (polygon.empty())
      continue;
    if (intersects_itself(polygon))
      findings.add(
          path,
          "'polygon' crosses or touches itself: list the corners in order around the region, each once");
    else if (!(area(polygon) > 0.0))
      findings.add(path, "'polygon' has no area");
  }
}

} // namespace tremolo::scene
