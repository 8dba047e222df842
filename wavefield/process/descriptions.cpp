#include "wavefield/process/descriptions.hpp"

#include <cmath>
#include <cstdint>
#include <string>

namespace tremolo::wavefield {

double served_interval(double highest_frequency) {
  constexpr double samples_per_period = 20.0;
  return 1.0 / (samples_per_period * highest_frequency);
}

std::vector<coupler::FieldDescription> descriptions(const scene::Service& service, double slowness_x,
                                                    double dt, std::string_view suffix) {
  std::vector<coupler::FieldDescription> fields;
  for (const scene::ServedLine& line : service.lines)
    fields.push_back(
        {.name = std::string(scene::name(line.field)).append(suffix),
         .y = line.levels,
         .x_reference = service.x_line,
         .slowness_x = slowness_x,
         .start_time = service.start_time - 2.0 * dt,
         .time_step = dt,
         .step_count =
             static_cast<std::uint64_t>(std::ceil((service.end_time - service.start_time) / dt)) + 4});
  return fields;
}

} // namespace tremolo::wavefield
