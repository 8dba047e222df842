#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void reference_lies_in_halfspace(const Case& scene, Findings& findings) {
  if (scene.profile.empty() || !findings.sound("motion.reference") || !findings.sound("surface.level"))
    return;
  double depth = 0.0;
  for (const Layer& layer : scene.profile)
    depth += layer.thickness;
  const double highest = std::min(scene.boundary.left.surface, scene.boundary.right.surface) - depth;
  if (scene.motion.reference.y > highest)
    findings.add(
        "motion.reference",
        fmt::format(
            "'reference' at y = {} lies in the layers of [[profile]], must be in the half-space, y <= {}",
            scene.motion.reference.y, highest));
}

} // namespace tremolo::scene
