#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void linings_suit_case(const Case& scene, Findings& findings) {
  if (scene.linings.empty())
    return;
  if (scene.time.transfer != Transfer::apic && findings.sound("time.transfer"))
    findings.add("time.transfer",
                 fmt::format("'transfer' = \"{}\" is for cases without [[lining]], must be \"apic\": contact "
                             "changes the velocity that particles take from the grid",
                             name(scene.time.transfer)));
  if (scene.time.subcycle && findings.sound("time.subcycle"))
    findings.add("time.subcycle",
                 "'subcycle' = true is for cases without [[lining]]: a lining answers to all "
                 "the soil that it touches in one step, the same for all levels");
  if (scene.mesh.dispersion == Dispersion::reduced && findings.sound("mesh.dispersion"))
    findings.add("mesh.dispersion",
                 "'dispersion' = \"reduced\" is for cases without [[lining]]: what rests on "
                 "sharpened soil does not stay at rest");
  if (scene.boundary.has_shaking_table() && findings.sound("boundary.base.model"))
    findings.add("boundary.base.model", "soil on a shaking table carries no linings: their inertia there was "
                                        "not studied");
}

} // namespace tremolo::scene
