#include "scene/plan/levels.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void softening_goes_with_cells(const Case& scene, Findings& findings) {
  if (scene.mesh.refine.empty())
    return;
  const auto all = levels(scene);
  for (const Soil& soil : domain_soils(scene)) {
    if (!soil.softening_size || !(materials::traits(soil.law).softening > 0.0) || all.size() == 1)
      continue;
    findings.add(
        "soil." + soil.name + ".softening",
        fmt::format(
            "soil '{}': softening eta = {}", soil.name, by_level(all, [&](double h) {
              return materials::traits(materials::for_cell_size(soil.law, h, *soil.softening_size)).softening;
            })));
  }
}

} // namespace tremolo::scene
