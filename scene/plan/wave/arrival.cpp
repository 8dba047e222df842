#include "scene/plan/wave/arrival.hpp"

#include "motion/record.hpp"
#include "scene/plan/wave/motion.hpp"
#include "scene/plan/wave/slowness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::scene {

double delay_to_model(const Case& scene, const MotionInput& wave) {
  if (!scene.boundary.takes_waves())
    return 0.0;
  const double angle = wave.angle_deg * std::numbers::pi / 180.0;
  const double dx = scene.mesh.box.x_min - wave.reference.x;
  const double dy = scene.mesh.box.y_min - wave.reference.y;
  return (dx * std::sin(angle) + dy * std::cos(angle)) / incident_speed(scene, wave);
}

double arrival_of_intensity(const Case& scene, const ShakingMotion& shaking, double share) {
  const SampledMotion samples = sampled(motion(shaking));
  double sum = 0.0;
  std::vector<double> intensity;
  for (const double a : motion::differentiate(samples.velocity, samples.dt))
    intensity.push_back(sum += a * a);
  const auto reached = std::ranges::lower_bound(intensity, share * sum);
  const double since_start = samples.time(static_cast<std::size_t>(reached - intensity.begin())) +
                             delay_to_model(scene, scene.motion) - shaking.start;
  return scene.timed[shaking.stage].start + since_start;
}

double incident_peak_velocity(const Case& scene) {
  const double factor = scene.motion.kind == motion::MotionKind::incident ? 1.0 : 0.5;
  double peak = 0.0;
  for (const double v : sampled(motion(scene.motion)).velocity)
    peak = std::max(peak, std::abs(v));
  return factor * peak;
}

} // namespace tremolo::scene
