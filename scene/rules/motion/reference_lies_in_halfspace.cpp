#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace tremolo::scene {

void reference_lies_in_halfspace(const Case& scene, Findings& findings) {
  if (scene.boundary.has_shaking_table() || !findings.sound("motion.reference") ||
      !findings.sound("surface.level"))
    return;
  const double y = scene.motion.reference.y;
  const auto check = [&](const LateralBoundary& side, const char* where) {
    const auto& below = layers(scene, side);
    const double top = base_level(side.surface, below);
    constexpr double same_level = 1e-6; // m
    if (!below.empty() && y > top + same_level)
      findings.add("motion.reference",
                   fmt::format("'reference' at y = {} lies in the layers{}, must be in the half-space, y "
                               "<= {}",
                               y, where, top));
    else if (scene.motion.kind == motion::MotionKind::within &&
             (below.empty() || std::abs(y - top) > same_level))
      findings.add(
          "motion.reference",
          fmt::format("'reference' at y = {} of a motion within the ground must be at the top of the "
                      "half-space{}, y = {}",
                      y, where, top));
  };
  const auto& [sides, left, right, base] = scene.boundary;
  const bool differ = !scene.boundary.has_equal_sides();
  check(left, differ ? " of the left side" : "");
  if (differ)
    check(right, " of the right side");
}

} // namespace tremolo::scene
