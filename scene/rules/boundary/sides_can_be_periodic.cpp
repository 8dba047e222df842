#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void sides_can_be_periodic(const Case& scene, Findings& findings) {
  const Boundary& boundary = scene.boundary;
  if (boundary.has_lateral_fields() || !findings.sound("boundary.sides"))
    return;
  for (const MotionInput* wave : scene.plane_waves())
    if (boundary.sides != Sides::container && findings.sound(wave->path + ".angle_deg") &&
        wave->angle_deg != 0.0)
      findings.add(
          "boundary.sides",
          fmt::format("sides = \"{}\" repeat the model, but a wave at [{}] angle_deg = {} reaches its "
                      "right side later than its left; use sides = \"free_field\", or angle_deg = 0",
                      name(boundary.sides), wave->path, wave->angle_deg));
  if (boundary.sides == Sides::periodic_springs && boundary.base.absorber == Absorber::matched_layer)
    findings.add("boundary.base.absorber",
                 "absorber = \"matched_layer\" would end at sides that springs tie above it; use sides = "
                 "\"periodic\", or absorber = \"dashpots\"");
  for (const auto& [side, host] : scene.hosts.sides)
    if (side != Side::base)
      findings.add(fmt::format("hosts.{}", name(side)),
                   fmt::format("sides = \"{}\" have no free field that could run elsewhere; remove the table",
                               name(boundary.sides)));
}

} // namespace tremolo::scene
