#include "scene/plan/boundary/springs.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

namespace {

/// Recommended distance from the middle of the settling structures to each side, in depths of the model.
constexpr double wanted_depths = 4.0;

} // namespace

void sides_are_far_from_structures(const Case& scene, Findings& findings) {
  const bool yields = std::ranges::any_of(scene.soils, [](const Soil& soil) {
    return materials::traits(soil.law).response != materials::Response::elastic;
  });
  if (scene.structures.empty() || !yields || !scene.boundary.has_lateral_fields())
    return;
  const Box& box = scene.mesh.box;
  const Point centre = spring_centre(scene);
  const double depth = centre.y - box.y_min;
  const double half_width = std::min(centre.x - box.x_min, box.x_max - centre.x);
  if (half_width < wanted_depths * depth)
    findings.add(
        "mesh.box",
        fmt::format("the nearer side is {:.3g} m from the middle of the structures: their settlement "
                    "depends on the box unless that is 4 depths of the model, {:.3g} m; springs and "
                    "matched layers hold them, and a run in another box shows how much it is "
                    "(docs/boundaries.md)",
                    half_width, wanted_depths * depth));
}

} // namespace tremolo::scene
