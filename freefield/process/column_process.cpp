// tremolo-column: serves a laterally uniform free field, marched in time as the domain requests it.

#include "coupler/participant.hpp"
#include "freefield/process/column_from_case.hpp"
#include "freefield/process/column_values.hpp"
#include "freefield/process/incident_field.hpp"
#include "scene/plan/service.hpp"
#include "scene/plan/wave/slowness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::freefield {

namespace {

void write(const freefield::ColumnSample& sample, std::span<double> values) {
  std::ranges::copy(freefield::served_values(sample), values.begin());
}

/// The column's state at the requested step; steps are requested in order.
class TotalField {
public:
  explicit TotalField(freefield::Column& column) : column_(column) {}

  void fill(std::uint64_t step, std::span<const double> levels, std::span<double> values) {
    for (; at_ < step; ++at_)
      column_.step();
    samples_.resize(levels.size());
    column_.sample(levels, samples_);
    for (std::size_t i = 0; i < samples_.size(); ++i)
      write(samples_[i], values.subspan(i * coupler::values_per_point, coupler::values_per_point));
  }

private:
  freefield::Column& column_;
  std::vector<freefield::ColumnSample> samples_;
  std::uint64_t at_ = 0;
};

void run(const coupler::ParticipantOptions& options) {
  const scene::Case scene = scene::load(options.case_file);
  const scene::Plan plan = scene::plan(scene);
  const scene::SourceProcess& source = scene::source_named(plan, options.name);
  const double slowness = scene::slowness_x(scene, scene.motion);
  const scene::Service service = scene::service(scene, source, slowness);
  const auto column = freefield::column_from_case(scene, source, service.x_line, service.start_time);
  const double dt = column->time_step();

  const auto steps = static_cast<std::uint64_t>(std::ceil((service.end_time - column->time()) / dt)) + 4;
  std::vector<coupler::FieldDescription> fields;
  for (const scene::ServedLine& line : service.lines)
    fields.push_back({.name = std::string(scene::name(line.field)),
                      .y = line.levels,
                      .x_reference = service.x_line,
                      .slowness_x = slowness,
                      .start_time = column->time(),
                      .time_step = dt,
                      .step_count = steps});

  coupler::SourceClient client(options, fields);
  TotalField total(*column);
  std::vector<std::optional<freefield::IncidentField>> incident(fields.size());
  for (std::size_t f = 0; f < fields.size(); ++f)
    if (service.lines[f].field == scene::BaseForm::incident)
      incident[f].emplace(scene, source, service.x_line, fields[f].y,
                          wavefield::TimeGrid{column->time(), dt, steps});
  client.serve([&](std::size_t f, std::uint64_t step, std::span<double> values) {
    if (incident[f])
      incident[f]->fill(step, values);
    else
      total.fill(step, fields[f].y, values);
  });
  if (const std::string report = column->report(); !report.empty())
    fmt::print("column: {}\n", report);
}

} // namespace
} // namespace tremolo::freefield

int main(int argc, char** argv) {
  return tremolo::coupler::participant_main("tremolo-column", "A 1D free-field column, as a source.", argc,
                                            argv, tremolo::freefield::run);
}
