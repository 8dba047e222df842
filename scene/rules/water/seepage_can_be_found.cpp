// Conditions that the flow through a domain imposes on a case (mpm_domain/head/seepage_of_ground.hpp).

#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace tremolo::scene {

namespace {

double crest_of(const Case& scene) {
  double crest = -std::numeric_limits<double>::infinity();
  for (const Region& region : scene.regions)
    for (const Point& corner : region.polygon)
      crest = std::max(crest, corner.y);
  return crest;
}

void refuse_levels(const Case& scene, const SideLevels& levels, Findings& findings) {
  for (const auto& [key, level] : {std::pair("left", levels.left), std::pair("right", levels.right)})
    if (!(level > scene.mesh.box.y_min))
      findings.add(
          fmt::format("water.{}", key),
          fmt::format("'{}' = {:g} m does not lie above the base of the model at y = {:g} m: no water "
                      "flows below it",
                      key, level, scene.mesh.box.y_min));
  const double crest = crest_of(scene);
  if (levels.left != levels.right && std::max(levels.left, levels.right) >= crest)
    findings.add(
        "water.seepage",
        fmt::format("water at y = {:g} m on the left and {:g} m on the right would meet over the ground, "
                    "which rises to y = {:g} m: only ground above both keeps two levels apart",
                    levels.left, levels.right, crest));
}

} // namespace

void seepage_can_be_found(const Case& scene, Findings& findings) {
  if (!scene.water || !scene.water->seepage || !findings.sound("water") || !mesh_is_sound(scene, findings) ||
      !findings.sound("region"))
    return;
  refuse_levels(scene, *scene.water->seepage, findings);
  std::set<std::string> reported;
  for (const Region& region : scene.regions)
    for (std::size_t s = region.soil; s <= region.soil + region.cuts.size() && s < scene.soils.size(); ++s) {
      const Soil& soil = scene.soils[s];
      const std::string path = "soil." + soil.name;
      const bool flows = soil.pores && soil.pores->permeability > 0.0;
      if (!flows && findings.sound(path) && reported.insert(soil.name).second)
        findings.add(path,
                     fmt::format("missing '{}': with [water] seepage = true, water flows through all of the "
                                 "domain, and soil '{}' is part of it",
                                 soil.pores ? "permeability" : "porosity' and 'permeability", soil.name));
    }
}

} // namespace tremolo::scene
