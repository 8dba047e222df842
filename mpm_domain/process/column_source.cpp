#include "mpm_domain/process/column_source.hpp"

#include "coupler/participant.hpp"
#include "freefield/process/incident_field.hpp"
#include "mpm_domain/process/column_from_case.hpp"
#include "scene/plan/service.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

void write(std::span<const ColumnPoint> points, std::span<double> values) {
  auto next = values.begin();
  for (const ColumnPoint& p : points)
    for (const double value :
         {p.velocity.x, p.velocity.y, p.stress.xx, p.stress.yy, p.stress.xy, p.acceleration.x,
          p.acceleration.y, p.stress_rate.xx, p.stress_rate.yy, p.stress_rate.xy})
      *next++ = value;
}

} // namespace

void serve_column(const scene::Case& scene, const scene::Plan& plan, const scene::SourceProcess& source,
                  const coupler::ParticipantOptions& options) {
  const scene::Service service = scene::service(scene, source, 0.0);
  PeriodicColumnSpec spec = periodic_column_spec(scene, source, service.x_line);
  const double dt = plan.dt; // the domain's own step: both know the same times
  // A whole number of steps before time zero, and two for the exchange to interpolate.
  const double start = -dt * (std::ceil(std::max(0.0, -spec.start_time) / dt) + 2.0);
  spec.start_time = start;
  spec.time_step = dt;
  PeriodicColumn column(std::move(spec));

  const auto steps = static_cast<std::uint64_t>(std::ceil((service.end_time - start) / dt)) + 4;
  std::vector<coupler::FieldDescription> fields;
  std::vector<std::optional<freefield::IncidentField>> incident;
  for (const scene::ServedLine& line : service.lines) {
    const bool total = line.field == scene::BaseForm::total;
    fields.push_back({.name = std::string(scene::name(line.field)),
                      .y = total ? column.levels() : line.levels,
                      .x_reference = service.x_line,
                      .slowness_x = 0.0,
                      .start_time = start,
                      .time_step = dt,
                      .step_count = steps});
    incident.emplace_back();
    if (!total)
      incident.back().emplace(scene, source, service.x_line, line.levels,
                              wavefield::TimeGrid{start, dt, steps});
  }
  coupler::SourceClient client(options, fields);
  std::uint64_t at = 0;
  client.serve([&](std::size_t f, std::uint64_t step, std::span<double> values) {
    if (incident[f])
      return incident[f]->fill(step, values);
    if (step < at)
      throw std::logic_error("a column was asked for a step that it has left behind");
    for (; at < step; ++at)
      column.step();
    write(column.points(), values);
  });
}

} // namespace tremolo::mpm_domain
