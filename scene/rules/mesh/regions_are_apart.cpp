#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

std::string path(std::size_t region) {
  return fmt::format("region[{}].polygon", region);
}

} // namespace

void regions_are_apart(const Case& scene, Findings& findings) {
  const auto usable = [&](std::size_t i) {
    const Polygon& polygon = scene.regions[i].polygon;
    return !polygon.empty() && !intersects_itself(polygon) && area(polygon) > 0.0;
  };
  for (std::size_t i = 0; i < scene.regions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (usable(i) && usable(j) && overlap(scene.regions[i].polygon, scene.regions[j].polygon))
        findings.add(path(i),
                     fmt::format("'polygon' overlaps the one in line {}: regions may touch but not overlap",
                                 findings.place(path(j)).line));
}

} // namespace tremolo::scene
