#include "scene/plan/wave/slowness.hpp"

#include <cmath>
#include <numbers>

namespace tremolo::scene {

double incident_speed(const Case& scene, const MotionInput& wave) {
  return wave.wave == Wave::sv ? scene.halfspace.s_wave_speed() : scene.halfspace.p_wave_speed();
}

double slowness_x(const Case& scene, const MotionInput& wave) {
  const double sine = std::sin(wave.angle_deg * std::numbers::pi / 180.0);
  return sine > 0.0 ? sine / incident_speed(scene, wave) : 0.0;
}

} // namespace tremolo::scene
