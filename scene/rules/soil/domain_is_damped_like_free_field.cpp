#include "motion/measures.hpp"
#include "motion/read/read.hpp"
#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::scene {

namespace {

/// The pulse's central frequency, or one over the record's mean period, Hz.
double typical_frequency(const Case& scene) {
  if (const auto* pulse = std::get_if<RickerPulse>(&scene.motion.source))
    return pulse->frequency;
  const auto& file = std::get<MotionFile>(scene.motion.source);
  const double period = motion::measures(motion::read_record(file.path, file.as)).mean_period;
  return period > 0.0 ? 1.0 / period : 1.0;
}

/// Damping ratio times the time that a shear wave takes, over all layers, s.
double damped_time(const Case& scene, const LateralBoundary& side) {
  double sum = 0.0;
  for (const Layer& layer : layers(scene, side))
    sum += layer.damping * layer.thickness / layer.elastic.s_wave_speed();
  return sum;
}

} // namespace

void domain_is_damped_like_free_field(const Case& scene, Findings& findings) {
  if (scene.boundary.periodic() || scene.damping.model == DampingModel::none)
    return;
  const double time =
      std::max(damped_time(scene, scene.boundary.left), damped_time(scene, scene.boundary.right));
  if (!(time > 0.0))
    return;
  const double frequency = typical_frequency(scene);
  findings.add(
      "damping.model",
      fmt::format("the layers of the free field are damped, the domain is not: a shear wave of {:.3g} Hz "
                  "loses {:.2g} % of its amplitude on its way up through the layers, and nothing on its "
                  "way up through the domain",
                  frequency, 100.0 * (1.0 - std::exp(-2.0 * std::numbers::pi * frequency * time))));
}

} // namespace tremolo::scene
