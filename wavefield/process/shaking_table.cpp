#include "wavefield/process/shaking_table.hpp"

#include "scene/plan/service.hpp"
#include "scene/plan/wave/motion.hpp"
#include "wavefield/process/descriptions.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tremolo::wavefield {

namespace {

/// A motion, and whether it is along x (0) or y (1).
struct Along {
  scene::Motion motion;
  std::size_t direction;
};

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
  std::vector<Along> motions;
  double highest_frequency = 0.0;
  for (const scene::MotionInput* input : scene.plane_waves()) {
    motions.push_back({scene::motion(*input), input->wave == scene::Wave::sv ? 0u : 1u});
    highest_frequency = std::max(highest_frequency, motions.back().motion.highest_frequency());
  }
  const scene::Service service = scene::service(scene, source, 0.0);
  const double dt = served_interval(highest_frequency);
  const std::vector<coupler::FieldDescription> fields = descriptions(service, 0.0, dt);
  const double start = fields.front().start_time;
  coupler::SourceClient client(options, fields);
  client.serve([&](std::size_t, std::uint64_t step, std::span<double> values) {
    const double time = start + static_cast<double>(step) * dt;
    std::ranges::fill(values, 0.0);
    constexpr std::size_t rates = coupler::values_per_point / 2;
    for (std::size_t point = 0; point < values.size(); point += coupler::values_per_point)
      for (const auto& [motion, direction] : motions) {
        values[point + direction] = motion.velocity(time);
        values[point + rates + direction] = rate(motion, time, dt);
      }
  });
}

} // namespace tremolo::wavefield
