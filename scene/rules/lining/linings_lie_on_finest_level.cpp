#include "scene/plan/structures.hpp"
#include "scene/rules/lining/outlines.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void linings_lie_on_finest_level(const Case& scene, Findings& findings) {
  if (scene.mesh.refine.empty() || !mesh_is_sound(scene, findings))
    return;
  const int finest = std::ranges::max(scene.mesh.refine, {}, &Refinement::level).level;
  for (const Lining& lining : scene.linings) {
    if (!outline_is_sound(lining, findings))
      continue;
    const Box room = room_around(scene, lining.outline.corners);
    const double top = std::min(room.y_max, scene.mesh.box.y_max);
    const bool inside = std::ranges::any_of(scene.mesh.refine, [&](const Refinement& refine) {
      return refine.level == finest && refine.box.x_min <= room.x_min && refine.box.y_min <= room.y_min &&
             refine.box.x_max >= room.x_max && refine.box.y_max >= top;
    });
    if (!inside)
      findings.add(
          outline_path(lining),
          fmt::format("'{}' comes within two cells of cells larger than the finest, {:g} m, on which linings "
                      "meet soil; add [[refine]] with level = {} and box = [{:.6g}, {:.6g}, {:.6g}, {:.6g}]",
                      lining.outline.key, contact_cell_size(scene), finest, room.x_min, room.y_min,
                      room.x_max, room.y_max));
  }
}

} // namespace tremolo::scene
