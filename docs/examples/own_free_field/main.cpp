// my_field: TravellingPulse as a source. Everything else is tremolo's: what the case asks for, and the
// exchange.

#include "coupler/participant.hpp"
#include "scene/plan/service.hpp"
#include "travelling_pulse.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

using namespace tremolo;

void run(const coupler::ParticipantOptions& options) {
  const scene::Case scene = scene::load(options.case_file);
  const scene::Plan plan = scene::plan(scene);
  const scene::SourceProcess& source = scene::source_named(plan, options.name);
  const TravellingPulse pulse(scene.halfspace.density, scene.halfspace.s_wave_speed());

  // What the case asks for: fields, levels, time. Two steps more at either end, for the interpolation.
  const scene::Service service = scene::service(scene, source, 0.0);
  const double dt = 0.005;
  std::vector<coupler::FieldDescription> fields;
  for (const scene::ServedLine& line : service.lines)
    fields.push_back({.name = std::string(scene::name(line.field)),
                      .y = line.levels,
                      .x_reference = service.x_line,
                      .slowness_x = 0.0,
                      .start_time = service.start_time - 2.0 * dt,
                      .time_step = dt,
                      .step_count = 4 + static_cast<std::uint64_t>(
                                            std::ceil((service.end_time - service.start_time) / dt))});

  coupler::SourceClient client(options, fields);
  client.serve([&](std::size_t f, std::uint64_t step, std::span<double> values) {
    std::size_t i = 0;
    for (const double y : fields[f].y) {
      const Motion m = pulse.at(source.surface - y, fields[f].time(step), fields[f].name == "total");
      // vx, vy, sxx, syy, sxy, then the time derivatives of these five
      for (const double value :
           {m.velocity, 0.0, 0.0, 0.0, m.stress, m.velocity_rate, 0.0, 0.0, 0.0, m.stress_rate})
        values[i++] = value;
    }
  });
}

int main(int argc, char** argv) {
  return coupler::participant_main("my_field", "A free-field model of my own.", argc, argv, run);
}
