#include "scene/rules/rules.hpp"
#include "scene/soils/water_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void elastic_structures_suit_water(const Case& scene, Findings& findings) {
  if (!scene.water || !findings.sound("water"))
    return;
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    const Structure& structure = scene.structures[i];
    if (!structure.stiffness || !structure.hole || structure.hole->corners.empty())
      continue;
    const Point lowest = std::ranges::min(structure.hole->corners, {}, &Point::y);
    const double table = highest_table_at(scene, lowest.x);
    if (lowest.y < table)
      findings.add(fmt::format("{}.{}", structure.path, structure.hole->key),
                   fmt::format("'{}' reaches down to y = {:.4g} m, below the water table at {:g} m: a "
                               "structure with a hole there must be rigid",
                               structure.hole->key, lowest.y, table));
  }
}

} // namespace tremolo::scene
