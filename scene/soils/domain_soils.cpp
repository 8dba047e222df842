#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

std::vector<std::size_t> soils_of(const Region& region) {
  if (region.polygon.empty())
    return {region.soil};
  const auto [low, high] = std::ranges::minmax(region.polygon, {}, &Point::y);
  const double near = 1e-9 * (high.y - low.y);
  std::vector<std::size_t> soils;
  for (std::size_t s = region.soil_at(high.y - near); s <= region.soil_at(low.y + near); ++s)
    soils.push_back(s);
  return soils;
}

std::vector<std::reference_wrapper<const Soil>> domain_soils(const Case& scene) {
  std::vector<bool> there(scene.soils.size());
  if (!there.empty())
    for (const Region& region : scene.regions)
      for (const std::size_t s : soils_of(region))
        there[s] = true;
  std::vector<std::reference_wrapper<const Soil>> soils;
  for (std::size_t i = 0; i < scene.soils.size(); ++i)
    if (there[i])
      soils.emplace_back(scene.soils[i]);
  return soils;
}

bool domain_is_damped(const Case& scene) {
  return std::ranges::any_of(domain_soils(scene), [](const Soil& soil) { return soil.damping > 0.0; });
}

std::vector<std::reference_wrapper<const Soil>>
one_of_each_name(std::vector<std::reference_wrapper<const Soil>> soils) {
  soils.erase(std::unique(soils.begin(), soils.end(),
                          [](const Soil& one, const Soil& other) { return one.name == other.name; }),
              soils.end());
  return soils;
}

std::vector<NamedSoil> named_soils(const Case& scene) {
  std::vector<NamedSoil> named;
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    const Soil& soil = scene.soils[i];
    const auto profile =
        std::ranges::find_if(scene.soil_profiles, [&](const SoilProfile& one) { return one.has(i); });
    if (profile == scene.soil_profiles.end()) {
      named.push_back({soil.name, soil});
      continue;
    }
    const std::size_t slice = i - profile->first;
    if (slice != 0 && slice + 1 != profile->slices())
      continue;
    named.push_back({soil.name, soil});
    named.back().soil.name =
        fmt::format("{}, y = {:g} to {:g} m", soil.name, profile->levels[slice], profile->levels[slice + 1]);
  }
  return named;
}

} // namespace tremolo::scene
