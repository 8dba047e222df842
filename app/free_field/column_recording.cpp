#include "app/free_field/column_recording.hpp"

#include "app/free_field/free_field_series.hpp"
#include "freefield/process/column_from_case.hpp"
#include "freefield/process/column_values.hpp"
#include "results/free_field_recording.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/service.hpp"
#include "scene/plan/wave/motion.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tremolo::app {

namespace {

/// In the order of a recording, level after level of one step.
std::vector<double> in_steps(const FreeFieldSeries& series) {
  std::vector<double> values;
  values.reserve(series.samples.size() * results::recorded_values);
  for (std::size_t i = 0; i < series.times.count; ++i)
    for (std::size_t k = 0; k < series.levels.size(); ++k)
      std::ranges::copy(freefield::served_values(series.at(k)[i]), std::back_inserter(values));
  return values;
}

/// Times that cover what the domain asks for, with two steps more on either side to interpolate; as fine as
/// tremolo-wave serves them.
wavefield::TimeGrid times_of(const scene::Case& scene, const scene::Service& service) {
  constexpr double samples_per_period = 20.0;
  const double dt = 1.0 / (samples_per_period * scene::motion(scene.motion).highest_frequency());
  const double start = service.start_time - 2.0 * dt;
  return {start, dt, static_cast<std::size_t>(std::ceil((service.end_time - service.start_time) / dt)) + 4};
}

/// The layers, for people.
std::string ground_text(const scene::Case& scene, const scene::SourceProcess& source) {
  std::string text = fmt::format("surface at y = {} m", source.surface);
  for (const scene::Layer& layer : scene::layers(scene, source))
    text += fmt::format("; {} m of {} kg/m3, c_s {:.6g} m/s, c_p {:.6g} m/s, damping {}", layer.thickness,
                        layer.elastic.density, layer.elastic.s_wave_speed(), layer.elastic.p_wave_speed(),
                        layer.damping);
  return text + fmt::format("; half-space of {} kg/m3, c_s {:.6g} m/s, c_p {:.6g} m/s",
                            scene.halfspace.density, scene.halfspace.s_wave_speed(),
                            scene.halfspace.p_wave_speed());
}

} // namespace

void record_column(const scene::Case& scene, scene::Side side, const std::filesystem::path& file) {
  const scene::Plan plan = scene::plan(scene);
  const scene::SourceProcess& source = scene::source_of(plan, side);
  const double slowness = freefield::slowness_from_case(scene);
  const scene::Service service = scene::service(scene, source, slowness);
  const wavefield::TimeGrid times = times_of(scene, service);

  std::vector<std::vector<double>> values;
  std::vector<results::FieldToRecord> fields;
  values.reserve(service.lines.size());
  for (const scene::ServedLine& line : service.lines) {
    const bool incident = line.field == scene::BaseForm::incident;
    values.push_back(in_steps(incident
                                  ? incident_series(scene, source, line.levels, times, service.x_line)
                                  : free_field_series(scene, source, line.levels, times, service.x_line)));
    fields.push_back({{.name = std::string(scene::name(line.field)),
                       .levels = line.levels,
                       .x_reference = service.x_line,
                       .slowness_x = slowness,
                       .start_time = times.start,
                       .time_step = times.dt,
                       .step_count = times.count},
                      values.back()});
  }
  results::write_free_field_recording(
      file, fmt::format("{}, model {}", scene.title, scene::name(source.field.model)),
      ground_text(scene, source), fields);
}

} // namespace tremolo::app
