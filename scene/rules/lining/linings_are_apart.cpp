#include "scene/plan/structures.hpp"
#include "scene/rules/lining/outlines.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

#include <string_view>

namespace tremolo::scene {

namespace {

bool boxes_overlap(const Box& a, const Box& b) {
  return a.x_min < b.x_max && a.x_max > b.x_min && a.y_min < b.y_max && a.y_max > b.y_min;
}

} // namespace

void linings_are_apart(const Case& scene, Findings& findings) {
  if (!mesh_is_sound(scene, findings))
    return;
  for (std::size_t i = 0; i < scene.linings.size(); ++i) {
    const Lining& lining = scene.linings[i];
    if (!outline_is_sound(lining, findings))
      continue;
    const Box room = room_around(scene, lining.outline.corners);
    const auto refuse_near = [&](std::string_view what, const std::string& path, const Polygon& outline) {
      if (boxes_overlap(room, room_around(scene, outline)))
        findings.add(
            outline_path(lining),
            fmt::format("the box around '{}' comes within four cells, {:g} m, of that around the {} in "
                        "line {}: both would meet the same soil",
                        lining.outline.key, 4.0 * contact_cell_size(scene), what, findings.place(path).line));
    };
    for (std::size_t s = 0; s < scene.structures.size(); ++s)
      if (outline_is_sound(scene, s, findings))
        refuse_near("structure", outline_path(scene, s), scene.structures[s].outline.corners);
    for (std::size_t other = 0; other < i; ++other)
      if (outline_is_sound(scene.linings[other], findings))
        refuse_near("lining", outline_path(scene.linings[other]), scene.linings[other].outline.corners);
  }
}

} // namespace tremolo::scene
