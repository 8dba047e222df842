#include "scene/soils/domain_soils.hpp"

#include <algorithm>

namespace tremolo::scene {

std::vector<std::reference_wrapper<const Soil>> domain_soils(const Case& scene) {
  std::vector<std::reference_wrapper<const Soil>> soils;
  for (std::size_t i = 0; i < scene.soils.size(); ++i)
    if (std::ranges::find(scene.regions, i, &Region::soil) != scene.regions.end())
      soils.emplace_back(scene.soils[i]);
  return soils;
}

} // namespace tremolo::scene
