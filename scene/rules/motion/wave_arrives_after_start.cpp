#include "scene/plan/wave/arrival.hpp"
#include "scene/plan/wave/motion.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

/// Of the peak: what is missing below it changes no result.
constexpr double negligible_velocity = 1e-3;

} // namespace

void wave_arrives_after_start(const Case& scene, Findings& findings) {
  const Motion wave = motion(scene.motion);
  const double delay = delay_to_model(scene);
  if (!(wave.begin() + delay < 0.0))
    return;
  const SampledMotion samples = sampled(wave);
  double peak = 0.0;
  double missing = 0.0;
  double first = 0.0; // when more than a negligible part arrives
  for (const double v : samples.velocity)
    peak = std::max(peak, std::abs(v));
  for (std::size_t i = 0; i < samples.velocity.size(); ++i) {
    const double time = samples.time(i) + delay;
    if (time >= 0.0)
      break;
    const double v = std::abs(samples.velocity[i]);
    missing = std::max(missing, v);
    if (first == 0.0 && v > negligible_velocity * peak)
      first = time;
  }
  if (missing > negligible_velocity * peak)
    findings.add("motion",
                 fmt::format("the wave reaches the model {:.3g} s before the shaking starts and finds it "
                             "at rest: what came earlier, up to {:.2g} % of the peak velocity, is "
                             "missing; a later pulse or a deeper [motion] reference avoids it",
                             -first, 100.0 * missing / peak));
}

} // namespace tremolo::scene
