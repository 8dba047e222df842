#include "scene/plan/motion.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tremolo::scene {

namespace {

/// When the incident wave first reaches the model: at its lower left corner, s.
double first_arrival(const Case& scene) {
  const double speed =
      scene.motion.wave == Wave::sv ? scene.halfspace.s_wave_speed() : scene.halfspace.p_wave_speed();
  const double angle = scene.motion.angle_deg * std::numbers::pi / 180.0;
  const double dx = scene.mesh.box.x_min - scene.motion.reference.x;
  const double dy = scene.mesh.box.y_min - scene.motion.reference.y;
  return motion(scene.motion).begin() + (dx * std::sin(angle) + dy * std::cos(angle)) / speed;
}

} // namespace

void wave_arrives_after_start(const Case& scene, Findings& findings) {
  if (const double arrival = first_arrival(scene); arrival < 0.0)
    findings.add(
        "motion",
        fmt::format("the wave reaches the model {:.3g} s before the shaking starts and finds it at "
                    "rest: what came earlier is missing; a later pulse or a deeper [motion] reference "
                    "avoids it",
                    -arrival));
}

} // namespace tremolo::scene
