#include "app/free_field/column/column_levels.hpp"

#include "scene/plan/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::app {

namespace {

/// Whether two layers are slices of one soil whose properties vary over depth.
bool slices_of_one_soil(const scene::Case& scene, const scene::Layer& above, const scene::Layer& below) {
  return above.soil && below.soil && above.wet == below.wet &&
         std::ranges::any_of(scene.soil_profiles, [&](const scene::SoilProfile& soil) {
           return soil.has(*above.soil) && soil.has(*below.soil);
         });
}

} // namespace

std::vector<double> profile_levels(const ColumnGround& ground, const std::vector<double>& depths) {
  const auto& [scene, source, x] = ground;
  constexpr int intervals = 100;
  const double base = deepest_level(scene, source);
  std::vector<double> levels;
  levels.reserve(intervals + 1 + depths.size());
  for (int i = 0; i < intervals; ++i)
    levels.push_back(base + (source.surface - base) * i / intervals);
  levels.push_back(source.surface);
  for (const double depth : depths) {
    const double y = source.surface - depth;
    if (!(y >= base && y <= source.surface))
      throw std::runtime_error(fmt::format("--depths: {} m is outside the column, allowed are 0 to {} m",
                                           depth, source.surface - base));
    if (std::ranges::find(levels, y) == levels.end())
      levels.insert(std::ranges::lower_bound(levels, y), y);
  }
  return scene::with_interfaces(std::move(levels), source.surface, scene::layers(scene, source), 0.0);
}

std::vector<double> history_depths(const ColumnGround& ground, const std::vector<double>& asked) {
  const auto& [scene, source, x] = ground;
  std::vector<double> depths;
  for (const double depth : asked)
    if (std::ranges::find(depths, depth) == depths.end())
      depths.push_back(depth);
  if (!depths.empty())
    return depths;
  const std::vector<scene::Layer>& layers = scene::layers(scene, source);
  depths.push_back(0.0);
  double depth = 0.0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    depth += layers[i].thickness;
    if (i + 1 == layers.size() || !slices_of_one_soil(scene, layers[i], layers[i + 1]))
      depths.push_back(depth);
  }
  return depths;
}

} // namespace tremolo::app
