#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void monitors_lie_on_structures(const Case& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.monitors.size(); ++i) {
    const Monitor& monitor = scene.monitors[i];
    const std::string path = fmt::format("monitor[{}].point", i);
    if (!monitor.structure || !findings.sound(path) || !outline_is_sound(scene, *monitor.structure, findings))
      continue;
    const Structure& structure = scene.structures[*monitor.structure];
    if (!contains(structure.outline.corners, monitor.point))
      findings.add(path,
                   fmt::format("'point' [{}, {}] lies outside structure '{}', with which the monitor moves",
                               monitor.point.x, monitor.point.y, structure.name));
  }
}

} // namespace tremolo::scene
