#include "freefield/base_motion.hpp"

#include "freefield/profile.hpp"

#include <cmath>

namespace tremolo::freefield {

Rise rise_to_damped_soil(const Profile& profile, double slowness_x) {
  const auto cosine = [&](double speed) { return std::sqrt(1.0 - std::pow(slowness_x * speed, 2)); };
  Rise rise;
  for (auto layer = profile.layers.rbegin(); layer != profile.layers.rend(); ++layer) {
    if (layer->damping_ratio > 0.0)
      return rise;
    const double shear = layer->soil.s_wave_speed(), pressure = layer->soil.p_wave_speed();
    rise.x += layer->thickness / shear * cosine(shear);
    rise.y += layer->thickness / pressure * cosine(pressure);
  }
  return {}; // nothing is damped
}

Velocity reference_velocity(BaseKind kind, const InputVelocity& input, const Rise& rise, double time) {
  if (kind == BaseKind::rigid)
    return input(time);
  return {2.0 * input(time - rise.x).x, 2.0 * input(time - rise.y).y};
}

} // namespace tremolo::freefield
