#include "app/free_field/series/free_field_series.hpp"

#include "app/free_field/series/computed_field.hpp"
#include "scene/plan/free_field_traits.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

namespace tremolo::app {

namespace {

using freefield::ColumnSample;

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

FreeFieldSeries empty_series(std::vector<double> levels, const wavefield::TimeGrid& times) {
  FreeFieldSeries series{.levels = std::move(levels), .times = times, .samples = {}};
  series.samples.resize(series.levels.size() * times.count);
  return series;
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
  computed_field(scene, source, x_line, times.start)
      ->fill(series, time == TimeOf::soil ? scene.clock() : materials::SoilClock());
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
