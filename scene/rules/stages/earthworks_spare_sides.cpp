// A free field does not know what is built after a shaking, and its faces ride on the soil of the sides.

#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace tremolo::scene {

void earthworks_spare_sides(const Case& scene, Findings& findings) {
  if (!mesh_is_sound(scene, findings))
    return;
  const Box& box = scene.mesh.box;
  const double margin = 2.0 * scene.mesh.size;
  for (const Earthwork& work : scene.earthworks) {
    const auto look = [&](const std::vector<Region>& regions, const char* key) {
      for (const Region& region : regions) {
        if (region.polygon.empty())
          continue;
        const auto [left, right] = std::ranges::minmax(region.polygon, {}, &Point::x);
        if (scene.boundary.has_lateral_fields() &&
            (left.x < box.x_min + margin || right.x > box.x_max - margin))
          findings.add(
              work.path + key,
              fmt::format("'{}' comes nearer to a side than two cells, {:g} m: the free field there does "
                          "not have it",
                          region.name, margin));
      }
    };
    look(work.placed, ".place");
    look(work.removed, ".remove");
  }
}

} // namespace tremolo::scene
