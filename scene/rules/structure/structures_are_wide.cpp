#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"
#include "scene/thickness.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

/// The hole of an elastic structure, whose walls strain; a rigid one may have walls as thin as its lining is,
/// since soil meets its outline alone. A hole that has been refused is not measured against.
Polygon hole_between_walls(const Case& scene, std::size_t structure, const Findings& findings) {
  const Structure& one = scene.structures[structure];
  return one.hole && one.stiffness && findings.sound(fmt::format("{}.{}", one.path, one.hole->key))
             ? one.hole->corners
             : Polygon{};
}

} // namespace

void structures_are_wide(const Case& scene, Findings& findings) {
  if (!mesh_is_sound(scene, findings))
    return;
  constexpr double enough = 1.99; // cells: the flats of a circle's polygon lie a little inside it
  const double h = contact_cell_size(scene);
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    if (!outline_is_sound(scene, i, findings))
      continue;
    const Outline& outline = scene.structures[i].outline;
    const Polygon hole = hole_between_walls(scene, i, findings);
    const double wide = thickness(outline.corners, hole);
    if (wide >= enough * h)
      continue;
    const bool ring = wide < thickness(outline.corners, {});
    findings.add(
        outline_path(scene, i),
        fmt::format("'{}' is {:.3g} m thick at one place{}, must be at least two cells of {:g} m: {}; take a "
                    "thicker structure or smaller cells",
                    outline.key, wide,
                    ring ? fmt::format(", between it and '{}'", scene.structures[i].hole->key) : "", h,
                    ring ? "cells do not resolve a thinner wall"
                         : "soil on one side would meet that on the other"));
  }
}

} // namespace tremolo::scene
