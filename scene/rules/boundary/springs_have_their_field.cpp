#include "scene/plan/boundary/springs.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

void centre_lies_in_box(const Case& scene, const char* side, const SpringKeys& keys, Findings& findings) {
  const Box& box = scene.mesh.box;
  if (keys.centre && !box.contains(*keys.centre))
    findings.add(fmt::format("boundary.{}.spring_centre", side),
                 fmt::format("[{:g}, {:g}] lies outside [mesh] box: springs are as stiff as loads there ask "
                             "for; the middle of what bears on the ground is meant",
                             keys.centre->x, keys.centre->y));
}

} // namespace

void springs_have_their_field(const Case& scene, Findings& findings) {
  const auto& [sides, left, right, base] = scene.boundary;
  centre_lies_in_box(scene, "left", left.springs, findings);
  centre_lies_in_box(scene, "right", right.springs, findings);
  centre_lies_in_box(scene, "base", base.springs, findings);
  if (base_has_no_total_field(scene) && scene.gravity && !base.springs.given_up)
    findings.add(
        "boundary.base.form",
        fmt::format("form = \"incident\" with sides = \"{}\" has no total free field that springs of "
                    "the base could move against, so it has dashpots alone, which hold no static "
                    "force; form = \"total\" has springs, and spring = false says that none are wanted",
                    name(sides)));
  if (const auto springs = scene::springs(scene, Side::base);
      springs && springs->lags && (springs->across > 0.5 || springs->along > 0.25))
    findings.add("boundary.base.spring",
                 fmt::format("spring = [{:g}, {:g}] under sides that differ: the base lies between two free "
                             "fields, and stiff springs pull it where neither moves; [0.5, 0.25] at most "
                             "(docs/boundaries.md)",
                             springs->across, springs->along));
}

} // namespace tremolo::scene
