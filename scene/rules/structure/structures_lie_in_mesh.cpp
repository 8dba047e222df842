#include "scene/meeting_boxes.hpp"
#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void structures_lie_in_mesh(const Case& scene, Findings& findings) {
  if (!mesh_is_sound(scene, findings))
    return;
  constexpr double rounding = 1e-9;
  const double margin = 2.0 * contact_cell_size(scene);
  const Box& box = scene.mesh.box;
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    if (!outline_is_sound(scene, i, findings))
      continue;
    const Outline& outline = scene.structures[i].outline;
    const Box of_it = box_of(outline.corners);
    const double least = (1.0 - rounding) * margin;
    if (of_it.x_min < box.x_min + least || of_it.x_max > box.x_max - least || of_it.y_min < box.y_min + least)
      findings.add(
          outline_path(scene, i),
          fmt::format("'{}' spans x {:.6g} to {:.6g} and reaches down to y = {:.6g}, must lie two cells "
                      "inside the sides and the base of the mesh: in x {:.6g} to {:.6g}, above y = {:.6g}",
                      outline.key, of_it.x_min, of_it.x_max, of_it.y_min, box.x_min + margin,
                      box.x_max - margin, box.y_min + margin));
  }
}

} // namespace tremolo::scene
