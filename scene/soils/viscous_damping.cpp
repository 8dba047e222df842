#include "scene/soils/viscous_damping.hpp"

#include "scene/plan/wave/slowness.hpp"

#include <numbers>
#include <stdexcept>

namespace tremolo::scene {

double damping_time(const Damping& damping, double ratio) {
  if (damping.model == DampingModel::none || damping.model == DampingModel::constant || ratio == 0.0)
    return 0.0;
  const double sum = damping.model == DampingModel::rayleigh ? damping.frequencies[0] + damping.frequencies[1]
                                                             : damping.reference_hz.value_or(0.0);
  return sum > 0.0 ? ratio / (std::numbers::pi * sum) : 0.0;
}

double mass_damping(const Case& scene, double ratio) {
  if (scene.damping.model != DampingModel::rayleigh || ratio == 0.0)
    return 0.0;
  for (const MotionInput* wave : scene.plane_waves())
    if (slowness_x(scene, *wave) * scene.halfspace.p_wave_speed() >= 1.0)
      return 0.0;
  const auto [f1, f2] = scene.damping.frequencies;
  return 4.0 * std::numbers::pi * ratio * f1 * f2 / (f1 + f2);
}

materials::Relaxation relaxation(const Damping& damping, double ratio) {
  if (damping.model != DampingModel::constant || !damping.reference_hz)
    return {};
  try {
    return materials::relaxation({*damping.reference_hz, damping.band}, ratio);
  } catch (const std::invalid_argument&) {
    return {}; // the key that is out of range is an error of its own
  }
}

double relaxing_share_p(const Case& scene, const Layer& layer) {
  const bool pressed =
      layer.wet && layer.soil && scene.soils[*layer.soil].pores->drainage != materials::Drainage::drained;
  return pressed ? layer.elastic.shear_modulus() / layer.elastic.p_modulus() : 1.0;
}

bool acts_in_time(const Damping& damping, double ratio) {
  return damping_time(damping, ratio) > 0.0 || relaxation(damping, ratio).acts();
}

} // namespace tremolo::scene
