#include "started.hpp"

#include "app/free_field/series/free_field_series.hpp"
#include "freefield/process/column_from_case.hpp"
#include "freefield/process/incident_field.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/process/column_from_case.hpp"
#include "mpm_domain/process/spec_from_case.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/service.hpp"
#include "scene/plan/wave/slowness.hpp"
#include "wavefield/layers/long_field.hpp"
#include "wavefield/process/field_from_case.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tremolo::testing {

namespace {

constexpr int steps = 3;

wavefield::Part part_of(scene::BaseForm field) {
  return field == scene::BaseForm::incident ? wavefield::Part::incident : wavefield::Part::total;
}

/// The times of the first steps from a start.
wavefield::TimeGrid first_times(double start, double dt) {
  return {start, dt, steps + 1};
}

void start_wave(const scene::Case& scene, const scene::SourceProcess& source) {
  const wavefield::Superposition field = wavefield::field_from_case(scene, source);
  for (const wavefield::LayeredField& wave : field.waves()) {
    const scene::Service service = scene::service(scene, source, wave.slowness_x());
    for (const scene::ServedLine& line : service.lines) {
      const auto points = wavefield::points_on_line(service.x_line, line.levels);
      const wavefield::LongField whole(wave, points, first_times(service.start_time, 0.005),
                                       part_of(line.field));
      whole.sample(points, [](std::size_t, const std::vector<wavefield::History>&) {});
    }
  }
}

void start_marched(const scene::Case& scene, const scene::SourceProcess& source) {
  const scene::Service service = scene::service(scene, source, scene::slowness_x(scene, scene.motion));
  const auto column = freefield::column_from_case(scene, source, service.x_line, service.start_time);
  for (int i = 0; i < steps; ++i)
    column->step();
  for (const scene::ServedLine& line : service.lines)
    if (line.field == scene::BaseForm::incident)
      freefield::IncidentField(scene, source, service.x_line, line.levels,
                               first_times(column->time(), column->time_step()));
    else {
      std::vector<freefield::ColumnSample> samples(line.levels.size());
      column->sample(line.levels, samples);
    }
}

/// As serve_column() of tremolo-domain does.
void start_periodic(const scene::Case& scene, const scene::Plan& plan, const scene::SourceProcess& source) {
  const scene::Service service = scene::service(scene, source, 0.0);
  auto spec = mpm_domain::periodic_column_spec(scene, source, service.x_line);
  spec.start_time = -plan.dt * (std::ceil(std::max(0.0, -spec.start_time) / plan.dt) + 2.0);
  spec.time_step = plan.dt;
  mpm_domain::PeriodicColumn column(std::move(spec));
  for (int i = 0; i < steps; ++i)
    column.step();
  for (const scene::ServedLine& line : service.lines)
    if (line.field == scene::BaseForm::incident)
      freefield::IncidentField(scene, source, service.x_line, line.levels,
                               first_times(column.time(), plan.dt));
}

/// Under a free field at rest, which exchanges nothing that a step could refuse.
void start_domain(const scene::Case& scene) {
  mpm_domain::Domain domain(mpm_domain::spec_from_case(scene, 1));
  if (scene.gravity) {
    const auto reactions = mpm_domain::relax_under_gravity(
        domain, {scene.gravity->residual, scene.gravity->max_time}, [](long, double) {});
    mpm_domain::replace_constraints(domain, reactions);
  }
  mpm_domain::Stepper stepper(
      domain, 0.0, [](long, double, auto, auto field) { std::ranges::fill(field, eq6::FreeField{}); });
  for (int i = 0; i < steps; ++i)
    stepper.step();
}

} // namespace

void start_processes(const scene::Case& scene) {
  using enum scene::SourceModel;
  const scene::Plan plan = scene::plan(scene);
  scene::base_sources(scene, plan);
  for (const scene::SourceProcess& source : plan.sources)
    switch (source.field.model) {
    case wave:
    case eql:
      start_wave(scene, source);
      break;
    case fe:
    case ode:
      start_marched(scene, source);
      break;
    case mpm:
      start_periodic(scene, plan, source);
      break;
    default:
      break;
    }
  start_domain(scene);
}

void run_column(const app::ColumnGround& ground) {
  const wavefield::TimeGrid times = app::column_times(ground);
  const std::vector<double> levels{app::deepest_level(ground.scene, ground.source), ground.source.surface};
  app::free_field_series(ground.scene, ground.source, levels, first_times(times.start, times.dt), ground.x);
}

} // namespace tremolo::testing
