#include "scene/case.hpp"

namespace tremolo::scene {

const std::vector<Layer>& layers(const Case& scene, const LateralBoundary& side) {
  return side.own_profile.empty() ? scene.profile : side.own_profile;
}

double base_level(double surface, const std::vector<Layer>& layers) {
  for (const Layer& layer : layers)
    surface -= layer.thickness;
  return surface;
}

} // namespace tremolo::scene
