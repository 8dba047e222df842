#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void structures_suit_time_stepping(const Case& scene, Findings& findings) {
  if (scene.structures.empty())
    return;
  if (scene.time.transfer != Transfer::apic && findings.sound("time.transfer"))
    findings.add(
        "time.transfer",
        fmt::format("'transfer' = \"{}\" is for cases without [[structure]], must be \"apic\": contact "
                    "changes the velocity that particles take from the grid, and under \"{}\" they "
                    "keep their own",
                    name(scene.time.transfer), name(scene.time.transfer)));
  if (scene.time.subcycle && findings.sound("time.subcycle"))
    findings.add("time.subcycle",
                 "'subcycle' = true is for cases without [[structure]]: a body answers to all "
                 "the soil that it touches in one step, the same for all levels");
}

} // namespace tremolo::scene
