#include "scene/plan/wave/arrival.hpp"
#include "scene/plan/wave/motion.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

/// Velocity over its peak that changes no result where it is missing, 1.
constexpr double negligible_velocity = 1e-3;

/// The part of a wave that arrives before the start of its stage, s and 1.
struct Early {
  double by = 0.0;    ///< how long before, of all that is not negligible, s
  double share = 0.0; ///< its largest velocity over that of the motion, 1
};

/// @param delay  from the start of the stage until the motion's t = 0 reaches the model, s
Early early_part(const Motion& wave, double delay) {
  const SampledMotion samples = sampled(wave);
  double peak = 0.0;
  for (const double v : samples.velocity)
    peak = std::max(peak, std::abs(v));
  Early early;
  for (std::size_t i = 0; i < samples.velocity.size(); ++i) {
    const double time = samples.time(i) + delay;
    if (time >= 0.0)
      break;
    const double share = std::abs(samples.velocity[i]) / peak;
    early.share = std::max(early.share, share);
    if (early.by == 0.0 && share > negligible_velocity)
      early.by = -time;
  }
  return early;
}

void check(const ShakingMotion& shaking, double delay, Findings& findings) {
  const Motion wave = motion(shaking);
  if (!(wave.begin() + delay < shaking.start))
    return;
  const Early early = early_part(wave, delay - shaking.start);
  if (!(early.share > negligible_velocity))
    return;
  findings.add(shaking.path,
               fmt::format("the wave reaches the model {:.3g} s before {}, up to {:.2g} % of the peak "
                           "velocity, {}; a later pulse or a deeper [motion] reference avoids it",
                           early.by,
                           shaking.stage == 0 ? "the shaking starts and finds it at rest: what came earlier"
                                              : "its stage begins: what comes earlier",
                           100.0 * early.share,
                           shaking.stage == 0 ? "is missing" : "shakes the ground in the stage before"));
}

} // namespace

void wave_arrives_after_start(const Case& scene, Findings& findings) {
  for (const MotionInput* wave : scene.plane_waves())
    for (const ShakingMotion& shaking : wave->shakings)
      check(shaking, delay_to_model(scene, *wave), findings);
}

} // namespace tremolo::scene
