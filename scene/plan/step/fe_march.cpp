#include "scene/plan/step/fe_march.hpp"

#include <algorithm>

namespace tremolo::scene {

FeMarch fe_march(const Case& scene, const std::vector<Layer>& layers) {
  if (scene.motion.angle_deg != 0.0)
    return FeMarch::at_an_angle;
  const auto remembers = [&](const Layer& layer) {
    return layer.soil && materials::traits(scene.soils[*layer.soil].column_law).remembers_initial_stress;
  };
  return scene.water || std::ranges::any_of(layers, remembers) ? FeMarch::two_phases : FeMarch::one_phase;
}

} // namespace tremolo::scene
