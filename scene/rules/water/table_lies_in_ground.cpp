#include "scene/plan/wet_soils.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void table_lies_in_ground(const Case& scene, Findings& findings) {
  if (!scene.water || !scene.water->is_level())
    return;
  const double level = scene.water->level;
  const double surface =
      std::min({scene.surface_level, scene.boundary.left.surface, scene.boundary.right.surface});
  if (level > surface)
    findings.add("water.level",
                 fmt::format("the water table, y = {} m, stands {} m above the ground at y = {} m, which "
                             "carries the pressure of this free water; 'level' is an elevation, not a depth",
                             level, level - surface, surface));
  else if (soils_below_table(scene).empty())
    findings.add("water.level",
                 fmt::format("no soil lies below the water table, y = {} m: water has no effect; 'level' is "
                             "an elevation, not a depth",
                             level));
}

} // namespace tremolo::scene
