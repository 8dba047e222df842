#include "app/free_field/column_recording.hpp"

#include "app/free_field/series/free_field_series.hpp"
#include "freefield/process/column_values.hpp"
#include "results/free_field_recording.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/service.hpp"
#include "scene/plan/wave/motion.hpp"
#include "scene/plan/wave/slowness.hpp"
#include "wavefield/process/field_from_case.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::app {

namespace {

/// The values in the order of a recording: step by step, level after level.
std::vector<double> in_steps(const FreeFieldSeries& series) {
  std::vector<double> values;
  values.reserve(series.samples.size() * results::recorded_values);
  for (std::size_t i = 0; i < series.times.count; ++i)
    for (std::size_t k = 0; k < series.levels.size(); ++k)
      std::ranges::copy(freefield::served_values(series.at(k)[i]), std::back_inserter(values));
  return values;
}

/// Times that cover the domain's requests, with two more steps on either side for interpolation; as fine as
/// tremolo-wave serves them.
/// @param highest_frequency  of the motion, Hz
wavefield::TimeGrid times_of(double highest_frequency, const scene::Service& service) {
  constexpr double samples_per_period = 20.0;
  const double dt = 1.0 / (samples_per_period * highest_frequency);
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

/// Fields of a recording and their values.
struct Fields {
  std::vector<results::RecordedField> descriptions;
  std::vector<std::vector<double>> values;

  void add(const scene::ServedLine& line, std::string_view suffix, const scene::Service& service,
           double slowness, const wavefield::TimeGrid& times, const FreeFieldSeries& series) {
    descriptions.push_back({.name = std::string(scene::name(line.field)).append(suffix),
                            .levels = line.levels,
                            .x_reference = service.x_line,
                            .slowness_x = slowness,
                            .start_time = times.start,
                            .time_step = times.dt,
                            .step_count = times.count});
    values.push_back(in_steps(series));
  }
};

/// Plane waves have slownesses of their own, so each is recorded by itself.
Fields fields_of_waves(const scene::Case& scene, const scene::SourceProcess& source) {
  const wavefield::Superposition field = wavefield::field_from_case(scene, source);
  const auto waves = scene.plane_waves();
  Fields fields;
  for (std::size_t w = 0; w < waves.size(); ++w) {
    const double slowness = field.waves()[w].slowness_x();
    const scene::Service service = scene::service(scene, source, slowness);
    const wavefield::TimeGrid times = times_of(scene::motion(*waves[w]).highest_frequency(), service);
    const wavefield::Superposition alone({field.waves()[w]});
    for (const scene::ServedLine& line : service.lines) {
      const bool incident = line.field == scene::BaseForm::incident;
      fields.add(line, scene::suffix_of_wave(w), service, slowness, times,
                 plane_wave_series(alone, line.levels, times, service.x_line,
                                   incident ? wavefield::Part::incident : wavefield::Part::total));
    }
  }
  return fields;
}

/// The waves in a column have one slowness, so they are recorded together.
Fields fields_of_column(const scene::Case& scene, const scene::SourceProcess& source) {
  const double slowness = scene::slowness_x(scene, scene.motion);
  const scene::Service service = scene::service(scene, source, slowness);
  const wavefield::TimeGrid times = times_of(scene::highest_frequency(scene), service);
  Fields fields;
  for (const scene::ServedLine& line : service.lines) {
    const bool incident = line.field == scene::BaseForm::incident;
    fields.add(line, "", service, slowness, times,
               incident ? plane_wave_series(
                              wavefield::elastic_field(scene, scene::layers(scene, source), source.surface),
                              line.levels, times, service.x_line, wavefield::Part::incident)
                        : free_field_series(scene, source, line.levels, times, service.x_line));
  }
  return fields;
}

} // namespace

void record_column(const scene::Case& scene, scene::Side side, const std::filesystem::path& file) {
  const scene::Plan plan = scene::plan(scene);
  const scene::SourceProcess& source = scene::source_of(plan, side);
  const Fields fields = scene::in_frequency_domain(source.field.model) ? fields_of_waves(scene, source)
                                                                       : fields_of_column(scene, source);
  std::vector<results::FieldToRecord> all;
  for (std::size_t i = 0; i < fields.values.size(); ++i)
    all.push_back({fields.descriptions[i], fields.values[i]});
  results::write_free_field_recording(
      file, fmt::format("{}, model {}", scene.title, scene::name(source.field.model)),
      ground_text(scene, source), all);
}

} // namespace tremolo::app
