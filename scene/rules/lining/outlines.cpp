#include "scene/rules/lining/outlines.hpp"

#include "scene/meeting_boxes.hpp"
#include "scene/plan/structures.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

std::string outline_path(const Lining& lining) {
  return fmt::format("{}.{}", lining.path, lining.outline.key);
}

bool outline_is_sound(const Lining& lining, const Findings& findings) {
  return !lining.outline.corners.empty() && findings.sound(outline_path(lining));
}

Box room_around(const Case& scene, const Polygon& outline) {
  const double margin = 2.0 * contact_cell_size(scene);
  const Box box = box_of(outline);
  return {box.x_min - margin, box.y_min - margin, box.x_max + margin, box.y_max + margin};
}

} // namespace tremolo::scene
