#include "app/free_field/free_field_series.hpp"

#include "app/verify/hermite.hpp"
#include "freefield/process/column_from_case.hpp"
#include "freefield/process/column_values.hpp"
#include "mpm_domain/process/column_from_case.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "wavefield/process/field_from_case.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <utility>

namespace tremolo::app {

namespace {

using freefield::ColumnSample;

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

ColumnSample between(const ColumnSample& a, const ColumnSample& b, double dt, double s) {
  ColumnSample c;
  const auto join = [&](double ColumnSample::*value, double ColumnSample::*rate) {
    const Jet jet = hermite({a.*value, a.*rate}, {b.*value, b.*rate}, dt, s);
    c.*value = jet.value;
    c.*rate = jet.rate;
  };
  join(&ColumnSample::vx, &ColumnSample::vx_rate);
  join(&ColumnSample::vy, &ColumnSample::vy_rate);
  join(&ColumnSample::sxx, &ColumnSample::sxx_rate);
  join(&ColumnSample::syy, &ColumnSample::syy_rate);
  join(&ColumnSample::sxy, &ColumnSample::sxy_rate);
  c.ux = hermite({a.ux, a.vx}, {b.ux, b.vx}, dt, s).value;
  c.uy = hermite({a.uy, a.vy}, {b.uy, b.vy}, dt, s).value;
  c.eyy = a.eyy + s * (b.eyy - a.eyy);
  c.gxy = a.gxy + s * (b.gxy - a.gxy);
  c.pore_pressure = a.pore_pressure + s * (b.pore_pressure - a.pore_pressure);
  return c;
}

/// A sample with rates per second of a time that passes so many times (1) as fast as that of the simulation.
ColumnSample in_time_of_soil(ColumnSample sample, double speed) {
  for (double ColumnSample::*rate : {&ColumnSample::vx, &ColumnSample::vy, &ColumnSample::sxx_rate,
                                     &ColumnSample::syy_rate, &ColumnSample::sxy_rate})
    sample.*rate /= speed;
  for (double ColumnSample::*rate : {&ColumnSample::vx_rate, &ColumnSample::vy_rate})
    sample.*rate /= speed * speed;
  return sample;
}

/// A column marched in time, at rest before its start. States are sampled only at the ends of steps that
/// contain a requested time.
/// @param clock  of the times of the series
void march(freefield::Column& column, const materials::SoilClock& clock, FreeFieldSeries& series) {
  const std::size_t levels = series.levels.size();
  const double dt = column.time_step();
  std::vector<ColumnSample> before(levels);
  std::vector<ColumnSample> after(levels);
  for (std::size_t i = 0; i < series.times.count; ++i) {
    const double time = clock.simulated_time(series.times.start + static_cast<double>(i) * series.times.dt);
    if (column.time() < time) {
      while (column.time() + dt < time)
        column.step();
      column.sample(series.levels, before);
      column.step();
      column.sample(series.levels, after);
    }
    const double s = std::clamp(1.0 - (column.time() - time) / dt, 0.0, 1.0);
    for (std::size_t k = 0; k < levels; ++k)
      series.samples[k * series.times.count + i] =
          in_time_of_soil(between(before[k], after[k], dt, s), clock.speed(time));
  }
}

ColumnSample at_time(const wavefield::History& h, std::size_t i) {
  ColumnSample sample = freefield::sample_at(h, i);
  sample.ux = h.ux[i];
  sample.uy = h.uy[i];
  sample.eyy = h.eyy[i];
  sample.gxy = h.gxy[i];
  return sample;
}

FreeFieldSeries empty_series(std::vector<double> levels, const wavefield::TimeGrid& times) {
  FreeFieldSeries series{.levels = std::move(levels), .times = times, .samples = {}};
  series.samples.resize(series.levels.size() * times.count);
  return series;
}

void synthesise(const wavefield::Superposition& field, double x, wavefield::Part part,
                FreeFieldSeries& series) {
  const auto points = wavefield::points_on_line(x, series.levels);
  const auto histories = field.sample(points, series.times, part);
  for (std::size_t k = 0; k < histories.size(); ++k)
    for (std::size_t i = 0; i < series.times.count; ++i)
      series.samples[k * series.times.count + i] = at_time(histories[k], i);
}

/// The case whose later motions begin at the soil's own times, for models that simulate no other.
scene::Case in_time_of_soil(scene::Case scene) {
  const auto move = [&scene](scene::MotionInput& wave) {
    for (scene::ShakingMotion& shaking : wave.shakings)
      if (shaking.stage > 0)
        shaking.start = scene.timed[shaking.stage].start;
  };
  move(scene.motion);
  if (scene.vertical)
    move(*scene.vertical);
  return scene;
}

} // namespace

double peak(std::span<const ColumnSample> samples, double ColumnSample::*member) {
  double largest = 0.0;
  for (const ColumnSample& sample : samples)
    largest = std::max(largest, std::abs(sample.*member));
  return largest;
}

std::size_t peak_level(const FreeFieldSeries& series, double ColumnSample::*member) {
  std::size_t level = 0;
  double largest = 0.0;
  for (std::size_t k = 0; k < series.levels.size(); ++k)
    if (const double value = peak(series.at(k), member); value > largest) {
      largest = value;
      level = k;
    }
  return level;
}

FreeFieldSeries free_field_series(const scene::Case& given, const scene::SourceProcess& source,
                                  std::vector<double> levels, const wavefield::TimeGrid& times, double x_line,
                                  TimeOf time) {
  FreeFieldSeries series = empty_series(std::move(levels), times);
  const double before = cpu_seconds();
  const bool marches = !scene::in_frequency_domain(source.field.model);
  const scene::Case& scene = time == TimeOf::soil && !marches ? in_time_of_soil(given) : given;
  switch (source.field.model) {
  case scene::SourceModel::wave:
    synthesise(wavefield::field_from_case(scene, source), x_line, wavefield::Part::total, series);
    break;
  case scene::SourceModel::eql: {
    series.equivalent_linear = wavefield::equivalent_linear_from_case(scene, source);
    series.report = wavefield::summary(*series.equivalent_linear);
    synthesise(wavefield::field_from_case(scene, source, *series.equivalent_linear), x_line,
               wavefield::Part::total, series);
    break;
  }
  case scene::SourceModel::fe:
  case scene::SourceModel::ode:
  case scene::SourceModel::mpm: {
    const auto column = source.field.model == scene::SourceModel::mpm
                            ? mpm_domain::column_from_case(scene, source, x_line, times.start)
                            : freefield::column_from_case(scene, source, x_line, times.start);
    march(*column, time == TimeOf::soil ? scene.clock() : materials::SoilClock(), series);
    series.report = column->report();
    break;
  }
  default:
    throw std::invalid_argument(
        fmt::format("model \"{}\" is not computed here; wave, fe, ode, eql and mpm are",
                    scene::name(source.field.model)));
  }
  series.cpu_seconds = cpu_seconds() - before;
  return series;
}

FreeFieldSeries plane_wave_series(const wavefield::Superposition& field, std::vector<double> levels,
                                  const wavefield::TimeGrid& times, double x_line, wavefield::Part part) {
  FreeFieldSeries series = empty_series(std::move(levels), times);
  synthesise(field, x_line, part, series);
  return series;
}

} // namespace tremolo::app
