#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void structures_touch_soil(const Case& scene, Findings& findings) {
  const bool regions_known =
      std::ranges::none_of(scene.regions, [](const Region& r) { return r.polygon.empty(); });
  if (!regions_known || !findings.sound("region") || !mesh_is_sound(scene, findings))
    return;
  for (std::size_t i = 0; i < scene.structures.size(); ++i)
    if (outline_is_sound(scene, i, findings) && points_on_soil(scene, i).empty())
      findings.add(outline_path(scene, i),
                   fmt::format("'{}' touches no soil: a structure stands on or in a [[region]]",
                               scene.structures[i].outline.key));
}

} // namespace tremolo::scene
