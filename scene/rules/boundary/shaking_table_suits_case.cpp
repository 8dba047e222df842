#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

void motion_is_that_of_the_table(const MotionInput& motion, Findings& findings) {
  if (motion.kind != motion::MotionKind::within && findings.sound("motion.kind"))
    findings.add("motion.kind",
                 fmt::format("kind = \"{}\" is that of a wave in rock, but a shaking table moves as "
                             "prescribed: its motion is kind = \"within\"",
                             motion::name(motion.kind)));
  if (const std::string path = motion.path + ".angle_deg"; motion.angle_deg != 0.0 && findings.sound(path))
    findings.add(
        path,
        fmt::format("angle_deg = {}, but a shaking table moves along x (wave = \"SV\") or along y (wave = "
                    "\"P\"): leave the angle out",
                    motion.angle_deg));
}

} // namespace

void shaking_table_suits_case(const Case& scene, Findings& findings) {
  const Boundary& boundary = scene.boundary;
  if (!findings.sound("boundary.sides") || !findings.sound("boundary.base.model"))
    return;
  if (!boundary.has_shaking_table()) {
    if (boundary.sides == Sides::container)
      findings.add("boundary.sides",
                   "sides = \"container\" are walls that stand on a shaking table: they need "
                   "[boundary.base] model = \"shaking_table\"");
    return;
  }
  if (boundary.sides != Sides::container && boundary.sides != Sides::periodic)
    findings.add(
        "boundary.sides",
        fmt::format("sides = \"{}\", but a shaking table carries a container or ground that repeats itself: "
                    "use sides = \"container\" or \"periodic\"",
                    name(boundary.sides)));
  for (const MotionInput* motion : scene.plane_waves())
    motion_is_that_of_the_table(*motion, findings);
  if (!scene.structures.empty())
    findings.add("structure",
                 "soil on a shaking table carries no structures: their inertia there was not studied");
}

} // namespace tremolo::scene
