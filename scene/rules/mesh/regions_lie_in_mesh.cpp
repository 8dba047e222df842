#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void regions_lie_in_mesh(const Case& scene, Findings& findings) {
  if (!findings.sound("mesh.box"))
    return;
  const Box& box = scene.mesh.box;
  for (std::size_t i = 0; i < scene.regions.size(); ++i)
    for (const Point corner : scene.regions[i].polygon)
      if (!box.contains(corner)) {
        findings.add(
            scene.regions[i].path + ".polygon",
            fmt::format("corner [{}, {}] lies outside the mesh, must be in x {} to {} and y {} to {}",
                        corner.x, corner.y, box.x_min, box.x_max, box.y_min, box.y_max));
        break;
      }
}

} // namespace tremolo::scene
