#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <string_view>

namespace tremolo::scene {

void subcycling_suits_case(const Case& scene, Findings& findings) {
  if (!scene.time.subcycle || !findings.sound("time.subcycle"))
    return;
  const auto refuse = [&](std::string_view why) {
    findings.add("time.subcycle", fmt::format("'subcycle' = true {}", why));
  };
  if (scene.mesh.refine.empty() && findings.sound("refine"))
    refuse("needs levels: add [[refine]], or set it to false");
  if (scene.time.transfer != Transfer::apic && findings.sound("time.transfer"))
    refuse(fmt::format("needs transfer = \"apic\", found \"{}\"", name(scene.time.transfer)));
  if (scene.time.order != StepOrder::musl && findings.sound("time.order"))
    refuse(fmt::format("needs order = \"musl\", found \"{}\"", name(scene.time.order)));
  if (scene.boundary.sides == Sides::periodic_springs && findings.sound("boundary.sides"))
    refuse("needs sides = \"free_field\" or \"periodic\" in [boundary]: springs go by one step for all");
  if (scene.water)
    refuse(
        "is for cases without [water]: water flows between soil on all levels, and its fast waves allow the "
        "same short step wherever cells are equally fine");
}

} // namespace tremolo::scene
