#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace tremolo::scene {

namespace {

void wave_begins_in_halfspace(const Case& scene, const MotionInput& wave, Findings& findings) {
  const std::string path = wave.path + ".reference";
  const double y = wave.reference.y;
  const auto check = [&](const LateralBoundary& side, const char* where) {
    const auto& below = layers(scene, side);
    const double top = base_level(side.surface, below);
    constexpr double same_level = 1e-6; // m
    if (!below.empty() && y > top + same_level)
      findings.add(path,
                   fmt::format("'reference' at y = {} lies in the layers{}, must be in the half-space, y "
                               "<= {}",
                               y, where, top));
    else if (wave.kind == motion::MotionKind::within && (below.empty() || std::abs(y - top) > same_level))
      findings.add(path,
                   fmt::format("'reference' at y = {} of a motion within the ground must be at the top of "
                               "the half-space{}, y = {}",
                               y, where, top));
  };
  const auto& [sides, left, right, base] = scene.boundary;
  const bool differ = !scene.boundary.has_equal_sides();
  check(left, differ ? " of the left side" : "");
  if (differ)
    check(right, " of the right side");
}

} // namespace

void reference_lies_in_halfspace(const Case& scene, Findings& findings) {
  if (!scene.boundary.takes_waves() || !findings.sound("surface.level"))
    return;
  for (const MotionInput* wave : scene.plane_waves())
    if (findings.sound(wave->path + ".reference") && findings.sound("motion.reference"))
      wave_begins_in_halfspace(scene, *wave, findings);
}

} // namespace tremolo::scene
