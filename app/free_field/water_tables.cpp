#include "app/free_field/water_tables.hpp"

#include "motion/record.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::app {

namespace {

using freefield::ColumnSample;

constexpr std::size_t most_rows_in_time = 600;

/// A case without a gravity stage has weight all the same where stress is compared with that of the ground.
double gravity(const scene::Case& scene) {
  return scene.gravity ? scene.gravity->acceleration : motion::standard_gravity;
}

/// Levels once, from the base up: at an interface the one above.
std::vector<std::size_t> single_levels(const FreeFieldSeries& series) {
  std::vector<std::size_t> single;
  for (std::size_t k = 0; k < series.levels.size(); ++k)
    if (!freefield::from_below(series.levels, k))
      single.push_back(k);
  return single;
}

double ratio(double pore_pressure, double effective) {
  return effective > 0.0 ? pore_pressure / effective : 0.0;
}

double largest_pore_pressure(const FreeFieldSeries& series, std::size_t level) {
  return std::ranges::max(series.at(level), {}, &ColumnSample::pore_pressure).pore_pressure;
}

double time_at(const FreeFieldSeries& series, std::size_t i) {
  return series.times.start + static_cast<double>(i) * series.times.dt;
}

results::Table over_depth_and_time(const scene::Case& scene, const scene::SourceProcess& source,
                                   const FreeFieldSeries& series) {
  const auto levels = single_levels(series);
  const std::size_t stride = series.times.count / most_rows_in_time + 1;
  std::vector<double> time, y, pressure, ru;
  for (std::size_t i = 0; i < series.times.count; i += stride)
    for (const std::size_t k : levels) {
      time.push_back(time_at(series, i));
      y.push_back(series.levels[k]);
      pressure.push_back(series.at(k)[i].pore_pressure);
      ru.push_back(ratio(pressure.back(), initial_effective_stress(scene, source, y.back())));
    }
  return {{{"time", "s", std::move(time)},
           {"y", "m", std::move(y)},
           {"pore_pressure", "Pa", std::move(pressure)},
           {"pore_pressure_ratio", "1", std::move(ru)}}};
}

results::Table settlement(const FreeFieldSeries& series) {
  std::vector<double> time, down;
  const auto surface = series.at(series.levels.size() - 1);
  const auto base = series.at(0);
  for (std::size_t i = 0; i < series.times.count; ++i) {
    time.push_back(time_at(series, i));
    down.push_back(base[i].uy - surface[i].uy);
  }
  return {{{"time", "s", std::move(time)}, {"settlement", "m", std::move(down)}}};
}

/// The water below a source's surface, at rest.
scene::GroundWater water_of(const scene::Case& scene, const scene::SourceProcess& source) {
  return scene::at_level(*scene.water, scene::water_level(scene, source));
}

results::Table over_depth(const scene::Case& scene, const scene::SourceProcess& source,
                          const FreeFieldSeries& series) {
  std::vector<double> y, effective, pressure, ru, down;
  for (const std::size_t k : single_levels(series)) {
    y.push_back(series.levels[k]);
    effective.push_back(initial_effective_stress(scene, source, y.back()));
    pressure.push_back(water_of(scene, source).pressure(y.back(), gravity(scene)));
    ru.push_back(ratio(largest_pore_pressure(series, k), effective.back()));
    down.push_back(series.at(0).back().uy - series.at(k).back().uy);
  }
  return {{{"y", "m", std::move(y)},
           {"effective_stress", "Pa", std::move(effective)},
           {"pore_pressure", "Pa", std::move(pressure)},
           {"peak_pore_pressure_ratio", "1", std::move(ru)},
           {"settlement", "m", std::move(down)}}};
}

} // namespace

bool has_pore_pressure(const scene::Case& scene, const scene::SourceProcess& source) {
  return scene::traits(source.field.model).effective_stress &&
         std::ranges::any_of(scene::layers(scene, source), &scene::Layer::wet);
}

double initial_effective_stress(const scene::Case& scene, const scene::SourceProcess& source, double y) {
  const double g = gravity(scene);
  double top = source.surface;
  const auto water_pressure = [&](double at) {
    return scene.water ? water_of(scene, source).pressure(at, g) : 0.0;
  };
  double stress = water_pressure(source.surface);
  for (const scene::Layer& layer : scene::layers(scene, source)) {
    const double bottom = std::max(top - layer.thickness, y);
    stress += layer.elastic.density * g * std::max(top - bottom, 0.0);
    top -= layer.thickness;
  }
  return stress - water_pressure(y);
}

void add_water(const scene::Case& scene, const scene::SourceProcess& source, const FreeFieldSeries& series,
               std::size_t level, results::Table& history) {
  const double initial = initial_effective_stress(scene, source, series.levels[level]);
  std::vector<double> pressure, ru, effective;
  for (const ColumnSample& sample : series.at(level)) {
    pressure.push_back(sample.pore_pressure);
    ru.push_back(ratio(sample.pore_pressure, initial));
    effective.push_back(initial - sample.syy - sample.pore_pressure);
  }
  history.columns.push_back({"pore_pressure", "Pa", std::move(pressure)});
  history.columns.push_back({"pore_pressure_ratio", "1", std::move(ru)});
  history.columns.push_back({"effective_stress", "Pa", std::move(effective)});
}

std::vector<results::NamedTable> water_tables(const scene::Case& scene, const scene::SourceProcess& source,
                                              const FreeFieldSeries& series) {
  return {{"/water", over_depth_and_time(scene, source, series)},
          {"/settlement", settlement(series)},
          {"/initial", over_depth(scene, source, series)}};
}

std::string water_summary(const scene::Case& scene, const scene::SourceProcess& source,
                          const FreeFieldSeries& series) {
  double largest = 0.0;
  std::size_t where = 0;
  for (std::size_t k = 0; k < series.levels.size(); ++k) {
    const double ru =
        ratio(largest_pore_pressure(series, k), initial_effective_stress(scene, source, series.levels[k]));
    if (ru > largest) {
      largest = ru;
      where = k;
    }
  }
  const double down = series.at(0).back().uy - series.at(series.levels.size() - 1).back().uy;
  return fmt::format("  pore pressure      largest r_u {:.3g} at {:.4g} m below the surface\n"
                     "  settlement         {:.3g} m at the end\n",
                     largest, source.surface - series.levels[where], down);
}

} // namespace tremolo::app
