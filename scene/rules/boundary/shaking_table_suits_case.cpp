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
  if (scene.boundary.takes_waves() || !findings.sound("boundary.base.model"))
    return;
  for (const MotionInput* motion : scene.plane_waves())
    motion_is_that_of_the_table(*motion, findings);
}

} // namespace tremolo::scene
