#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void water_suits_sides(const Case& scene, Findings& findings) {
  if (!scene.water || scene.water->is_level() || !findings.sound("water") || !findings.sound("boundary"))
    return;
  const Sides sides = scene.boundary.sides;
  const char* const key = scene.water->seepage ? "water.seepage" : "water.line";
  if (sides == Sides::container && scene.water->seepage)
    findings.add(key, "the walls of a container let no water pass, so none seeps from one to the other: give "
                      "'level' or 'line' instead");
  const double left = scene.water->beside(Side::left);
  const double right = scene.water->beside(Side::right);
  if ((sides == Sides::periodic || sides == Sides::periodic_springs) && left != right)
    findings.add(
        key,
        fmt::format("the water stands at y = {:g} m at the left side and at {:g} m at the right one, and "
                    "sides = \"{}\" makes both one place: give them one level, or take sides = "
                    "\"free_field\"",
                    left, right, name(sides)));
}

} // namespace tremolo::scene
