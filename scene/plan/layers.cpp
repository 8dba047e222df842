#include "scene/plan/layers.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

const std::vector<Layer>& layers(const Case& scene, const LateralBoundary& side) {
  return side.own_profile.empty() ? scene.profile : side.own_profile;
}

const std::vector<Layer>& layers(const Case& scene, const SourceProcess& source) {
  if (!source.profile)
    return scene.profile;
  return *source.profile == Side::left ? scene.boundary.left.own_profile : scene.boundary.right.own_profile;
}

double base_level(double surface, const std::vector<Layer>& layers) {
  for (const Layer& layer : layers)
    surface -= layer.thickness;
  return surface;
}

std::vector<double> with_interfaces(std::vector<double> levels, double surface,
                                    const std::vector<Layer>& layers, double close) {
  double interface = surface;
  for (const Layer& layer : layers) {
    interface -= layer.thickness;
    if (interface <= levels.front())
      break;
    std::erase_if(levels, [&](double level) {
      return std::abs(level - interface) <= close && level != levels.front() && level != levels.back();
    });
    levels.insert(std::ranges::lower_bound(levels, interface), 2, interface);
  }
  return levels;
}

} // namespace tremolo::scene
