// A load stays on the soil or the structure that carries it from its stage on. Soil that comes or goes
// between its ends would bury it, or take it away, and so would a structure that goes.

#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace tremolo::scene {

namespace {

/// The first of the regions with one of these names that reaches between the ends of a load; null: none does.
const Region* region_at(const LoadStage& load, const std::vector<Region>& regions,
                        const std::vector<std::string>& names) {
  const auto found = std::ranges::find_if(regions, [&](const Region& region) {
    if (region.polygon.empty() || std::ranges::find(names, region.name) == names.end())
      return false;
    const auto [left, right] = std::ranges::minmax(region.polygon, {}, &Point::x);
    return left.x < load.x_max && right.x > load.x_min;
  });
  return found == regions.end() ? nullptr : &*found;
}

} // namespace

void constructions_spare_loads(const Case& scene, Findings& findings) {
  for (std::size_t c = 0; c < scene.constructions.size(); ++c) {
    const ConstructionStage& stage = scene.constructions[c];
    const std::vector<Region>& after =
        c + 1 < scene.constructions.size() ? scene.constructions[c + 1].before.regions : scene.regions;
    for (const LoadStage& load : std::span(scene.loads).first(stage.loads_before)) {
      if (load.on_structure()) {
        if (std::ranges::find(stage.remove, load.structure) != stage.remove.end())
          findings.add(stage.path + ".remove",
                       fmt::format("'{}' carries the load '{}', which stays: a structure that goes cannot "
                                   "be loaded before",
                                   load.structure, load.name));
        continue;
      }
      const auto refuse = [&](const char* key, const Region* region) {
        if (region != nullptr)
          findings.add(stage.path + key,
                       fmt::format("'{}' lies where the load '{}' acts, from x = {:g} to {:g} m, which would "
                                   "not stay where it is: build first and load then",
                                   region->name, load.name, load.x_min, load.x_max));
      };
      refuse(".remove", region_at(load, stage.before.regions, stage.remove));
      refuse(".place", region_at(load, after, stage.place));
    }
  }
}

} // namespace tremolo::scene
