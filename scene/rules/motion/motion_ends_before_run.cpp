#include "scene/plan/wave/arrival.hpp"
#include "scene/plan/wave/motion.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

/// Share of the motion's energy in an end of the record that is not worth a warning, 1.
constexpr double negligible_energy = 0.01;

void check(const Case& scene, const MotionInput& input, Findings& findings) {
  const ShakingMotion& last = input.shakings.back(); // that of each other one goes on in the next stages
  const Motion wave = motion(last);
  const double delay = delay_to_model(scene, input);
  const double end = scene.end();
  if (!(wave.end() + delay > end))
    return;
  const SampledMotion samples = sampled(wave);
  double all = 0.0;
  double late = 0.0;
  for (std::size_t i = 0; i < samples.velocity.size(); ++i) {
    const double energy = samples.velocity[i] * samples.velocity[i];
    all += energy;
    if (samples.time(i) + delay > end)
      late += energy;
  }
  if (late > negligible_energy * all)
    findings.add(last.path, fmt::format("{:.3g} % of the incident wave's energy reaches the model after the "
                                        "run's end at {:.6g} s; the wave ends at {:.4g} s",
                                        100.0 * late / all, end, wave.end() + delay));
}

} // namespace

void motion_ends_before_run(const Case& scene, Findings& findings) {
  for (const MotionInput* wave : scene.plane_waves())
    check(scene, *wave, findings);
}

} // namespace tremolo::scene
