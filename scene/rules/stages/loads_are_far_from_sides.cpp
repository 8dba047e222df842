// A free field does not know the load. At a distance of two of its widths from its end a strip still presses
// the ground sideways with some 8 % of its pressure (Boussinesq), which a side nearer than that would hold
// against a free field without it.

#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

namespace {

/// Recommended distance from an end of a load to a side, in widths of the load.
constexpr double wanted_widths = 2.0;

} // namespace

void loads_are_far_from_sides(const Case& scene, Findings& findings) {
  if (!scene.boundary.has_lateral_fields() || !mesh_is_sound(scene, findings))
    return;
  const Box& box = scene.mesh.box;
  for (const LoadStage& load : scene.loads) {
    if (load.on_structure())
      continue;
    const double width = load.x_max - load.x_min;
    const double distance = std::min(load.x_min - box.x_min, box.x_max - load.x_max);
    if (findings.sound(load.path + ".x_m") && distance < wanted_widths * width)
      findings.add(
          load.path + ".x_m",
          fmt::format("the load '{}' ends {:.3g} m before a side whose free field does not have it: "
                      "its stress reaches some {:g} of its widths, {:.3g} m; move the side, or see in "
                      "a wider box what that changes",
                      load.name, distance, wanted_widths, wanted_widths * width));
  }
}

} // namespace tremolo::scene
