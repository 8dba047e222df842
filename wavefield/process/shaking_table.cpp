#include "wavefield/process/shaking_table.hpp"

#include "scene/plan/service.hpp"
#include "scene/plan/wave/motion.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::wavefield {

namespace {

/// Samples per period of the highest frequency, between which the velocity is a Hermite polynomial.
constexpr double samples_per_period = 20.0;

/// dV/dt by central differences of fourth order (m/s2), whose error here is 1e-8 of the largest.
double rate(const scene::Motion& motion, double time, double interval) {
  const double e = 0.125 * interval;
  return (8.0 * (motion.velocity(time + e) - motion.velocity(time - e)) -
          (motion.velocity(time + 2.0 * e) - motion.velocity(time - 2.0 * e))) /
         (12.0 * e);
}

} // namespace

void serve_shaking_table(const scene::Case& scene, const scene::SourceProcess& source,
                         const coupler::ParticipantOptions& options) {
  const scene::Motion motion = scene::motion(scene.motion);
  const scene::Service service = scene::service(scene, source, 0.0);
  const scene::ServedLine& line = service.lines.front();
  const double dt = 1.0 / (samples_per_period * motion.highest_frequency());
  const double start = service.start_time - 2.0 * dt;
  coupler::SourceClient client(
      options,
      {{.name = std::string(scene::name(line.field)),
        .y = line.levels,
        .x_reference = service.x_line,
        .slowness_x = 0.0,
        .start_time = start,
        .time_step = dt,
        .step_count =
            static_cast<std::uint64_t>(std::ceil((service.end_time - service.start_time) / dt)) + 4}});
  const std::size_t direction = scene.motion.wave == scene::Wave::sv ? 0 : 1;
  client.serve([&](std::size_t, std::uint64_t step, std::span<double> values) {
    const double time = start + static_cast<double>(step) * dt;
    std::ranges::fill(values, 0.0);
    constexpr std::size_t rates = coupler::values_per_point / 2;
    for (std::size_t point = 0; point < values.size(); point += coupler::values_per_point) {
      values[point + direction] = motion.velocity(time);
      values[point + rates + direction] = rate(motion, time, dt);
    }
  });
}

} // namespace tremolo::wavefield
