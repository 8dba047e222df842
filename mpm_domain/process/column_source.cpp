#include "mpm_domain/process/column_source.hpp"

#include "coupler/participant.hpp"
#include "freefield/process/incident_field.hpp"
#include "freefield/process/incident_input.hpp"
#include "mpm_domain/column/periodic_column.hpp"
#include "mpm_domain/process/spec_from_case.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/service.hpp"
#include "scene/soils/viscous_damping.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// Adds a layer of the column between two levels.
void add_layer(Spec& spec, const materials::Law& law, const std::optional<materials::PoreSpace>& pores,
               double damping_time, double top, double bottom) {
  const double left = spec.box.x_min;
  const double right = spec.box.x_max;
  spec.regions.push_back({spec.soils.size(), {{left, bottom}, {right, bottom}, {right, top}, {left, top}}});
  spec.soils.push_back({std::to_string(spec.soils.size() + 1), law, {}, damping_time, pores});
}

/// One column of the model's coarsest cells under the source's surface: its layers, then the half-space. It
/// reaches down to the base of the model, or by whole cells more to where the half-space begins.
Spec column_spec(const scene::Case& scene, const scene::SourceProcess& source) {
  Spec spec = spec_from_case(scene, 1);
  spec.refine.clear();
  spec.scheme.subcycle = false;
  spec.box.x_max = spec.box.x_min + spec.cell_size;
  spec.box.y_max = source.surface;
  spec.soils.clear();
  spec.regions.clear();
  spec.matched_sides.clear();
  const double half_space = scene::base_level(source.surface, scene::layers(scene, source));
  spec.box.y_min -=
      spec.cell_size * std::ceil(std::max(0.0, spec.box.y_min - half_space) / spec.cell_size - 1e-9);
  double top = source.surface;
  for (const scene::Layer& layer : scene::layers(scene, source)) {
    const scene::Soil* const soil = layer.soil ? &scene.soils[*layer.soil] : nullptr;
    add_layer(spec, soil != nullptr ? soil->law : materials::LinearElastic{layer.elastic},
              soil != nullptr ? soil->pores : std::nullopt, scene::damping_time(scene.damping, layer.damping),
              top, top - layer.thickness);
    top -= layer.thickness;
  }
  if (top > spec.box.y_min)
    add_layer(spec, materials::LinearElastic{scene.halfspace}, std::nullopt, 0.0, top, spec.box.y_min);
  return spec;
}

/// Velocity and stress of the incident wave at the base: sxy = -rho c_s vx, syy = -rho c_p vy, sxx = lambda/M
/// syy.
IncidentWave incident_wave(const materials::Elasticity& ground, const freefield::InputVelocity& velocity) {
  return [ground, velocity](double time) -> eq6::FreeField {
    const freefield::Velocity v = velocity(time);
    const double syy = -ground.density * ground.p_wave_speed() * v.y;
    return {{v.x, v.y},
            {ground.lame() / ground.p_modulus() * syy, syy, -ground.density * ground.s_wave_speed() * v.x}};
  };
}

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
  const Spec spec = column_spec(scene, source);
  const auto input = freefield::incident_input(scene, source, service.x_line, spec.box.y_min);
  const double dt = plan.dt; // the domain's own step: both know the same times
  // A whole number of steps before time zero, and two for the exchange to interpolate.
  const double start = -dt * (std::ceil(std::max(0.0, -input.begin) / dt) + 2.0);
  PeriodicColumn column({spec, scene.halfspace, incident_wave(scene.halfspace, input.velocity), start, dt});

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
