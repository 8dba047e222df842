// Soil below the water shares its pore water with the ground around it, which one node of the grid cannot
// hand over while the water flows: what is placed or removed after a shaking lies above it. Where the level
// varies, the domain looks at each particle before it is shaken.

#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace tremolo::scene {

void earthworks_are_dry(const Case& scene, Findings& findings) {
  if (!scene.water || !scene.water->is_level())
    return;
  const double level = scene.water->highest();
  for (const Earthwork& work : scene.earthworks) {
    const auto look = [&](const std::vector<Region>& regions, const char* key) {
      for (const Region& region : regions) {
        if (region.polygon.empty() || !scene.soils[region.soil].pores)
          continue;
        if (const double low = std::ranges::min(region.polygon, {}, &Point::y).y; low < level)
          findings.add(
              work.path + key,
              fmt::format("'{}' reaches down to y = {:g} m, below the water at y = {:g} m: after a shaking "
                          "soil above the water alone is placed and removed",
                          region.name, low, level));
      }
    };
    look(work.placed, ".place");
    look(work.removed, ".remove");
  }
}

} // namespace tremolo::scene
