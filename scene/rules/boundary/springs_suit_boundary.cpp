#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

void centre_has_springs(const char* side, const SpringKeys& keys, Findings& findings) {
  const std::string path = fmt::format("boundary.{}", side);
  if (keys.centre && keys.given_up && findings.sound(path + ".spring"))
    findings.add(path + ".spring_centre",
                 "spring_centre is the centre of springs, and spring = false has none; remove one of them");
}

} // namespace

void springs_suit_boundary(const Case& scene, Findings& findings) {
  const auto& [sides, left, right, base] = scene.boundary;
  centre_has_springs("left", left.springs, findings);
  centre_has_springs("right", right.springs, findings);
  centre_has_springs("base", base.springs, findings);
  const bool given = base.springs.stiffness || base.springs.centre;
  if (scene.boundary.base_is_rigid() && given && findings.sound("boundary.base.model"))
    findings.add("boundary.base.spring",
                 "a shaking table moves as its motion says, so no springs stand beside it; remove spring and "
                 "spring_centre");
}

} // namespace tremolo::scene
