#include "app/free_field/column_report.hpp"

#include "app/free_field/water_tables.hpp"
#include "motion/record.hpp"
#include "motion/spectra.hpp"
#include "scene/plan/layers.hpp"
#include "wavefield/incident_motion.hpp"
#include "wavefield/layers/half_space.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tremolo::app {

namespace {

using freefield::ColumnSample;
using Member = double ColumnSample::*;

std::vector<double> column_of(std::span<const ColumnSample> samples, Member member) {
  std::vector<double> values;
  values.reserve(samples.size());
  for (const ColumnSample& sample : samples)
    values.push_back(sample.*member);
  return values;
}

double peak(std::span<const ColumnSample> samples, Member member) {
  double largest = 0.0;
  for (const ColumnSample& sample : samples)
    largest = std::max(largest, std::abs(sample.*member));
  return largest;
}

std::vector<double> times_of(const wavefield::TimeGrid& grid) {
  std::vector<double> times;
  for (std::size_t i = 0; i < grid.count; ++i)
    times.push_back(grid.start + static_cast<double>(i) * grid.dt);
  return times;
}

/// Vertical total stress of the soil above a level, Pa.
double overburden(const scene::Case& scene, const scene::SourceProcess& source, double y) {
  double top = source.surface;
  double stress = 0.0;
  for (const scene::Layer& layer : scene::layers(scene, source)) {
    const double bottom = std::max(top - layer.thickness, y);
    stress += layer.elastic.density * motion::standard_gravity * std::max(top - bottom, 0.0);
    top -= layer.thickness;
  }
  return stress + scene.halfspace.density * motion::standard_gravity * std::max(top - y, 0.0);
}

results::Table history(const FreeFieldSeries& series, std::size_t level) {
  const auto samples = series.at(level);
  results::Table table{{{"time", "s", times_of(series.times)}}};
  const auto add = [&](const char* name, const char* unit, Member member) {
    table.columns.push_back({name, unit, column_of(samples, member)});
  };
  add("ax", "m/s2", &ColumnSample::vx_rate);
  add("ay", "m/s2", &ColumnSample::vy_rate);
  add("vx", "m/s", &ColumnSample::vx);
  add("vy", "m/s", &ColumnSample::vy);
  add("ux", "m", &ColumnSample::ux);
  add("uy", "m", &ColumnSample::uy);
  add("sxx", "Pa", &ColumnSample::sxx);
  add("syy", "Pa", &ColumnSample::syy);
  add("sxy", "Pa", &ColumnSample::sxy);
  add("gxy", "1", &ColumnSample::gxy);
  add("eyy", "1", &ColumnSample::eyy);
  return table;
}

results::Table profile(const scene::Case& scene, const scene::SourceProcess& source,
                       const FreeFieldSeries& series) {
  results::Table table{{{"y", "m", series.levels}}};
  const auto add = [&](const char* name, const char* unit, Member member) {
    std::vector<double> values;
    for (std::size_t k = 0; k < series.levels.size(); ++k)
      values.push_back(peak(series.at(k), member));
    table.columns.push_back({name, unit, std::move(values)});
  };
  add("peak_ax", "m/s2", &ColumnSample::vx_rate);
  add("peak_ay", "m/s2", &ColumnSample::vy_rate);
  add("peak_vx", "m/s", &ColumnSample::vx);
  add("peak_vy", "m/s", &ColumnSample::vy);
  add("peak_ux", "m", &ColumnSample::ux);
  add("peak_uy", "m", &ColumnSample::uy);
  add("peak_gxy", "1", &ColumnSample::gxy);
  add("peak_eyy", "1", &ColumnSample::eyy);
  add("peak_sxy", "Pa", &ColumnSample::sxy);
  std::vector<double> ratio;
  for (std::size_t k = 0; k < series.levels.size(); ++k) {
    const double vertical = overburden(scene, source, series.levels[k]);
    ratio.push_back(vertical > 0.0 ? peak(series.at(k), &ColumnSample::sxy) / vertical : 0.0);
  }
  table.columns.push_back({"stress_ratio", "1", std::move(ratio)});
  return table;
}

std::vector<double> pseudo_acceleration(const std::vector<double>& acceleration, double dt,
                                        const std::vector<double>& periods) {
  constexpr double damping = 0.05;
  std::vector<double> values;
  for (const auto& response : motion::response_spectrum(acceleration, dt, periods, damping))
    values.push_back(response.acceleration);
  return values;
}

results::Table spectra(const std::vector<double>& surface, const std::vector<double>& outcrop, double dt) {
  constexpr double shortest = 0.01; // s
  constexpr double longest = 10.0;  // s
  const auto periods = motion::tabulated_periods(std::max(shortest, 2.0 * dt), longest, 120);
  results::Table table{
      {{"period", "s", periods}, {"surface", "m/s2", pseudo_acceleration(surface, dt, periods)}}};
  if (!outcrop.empty())
    table.columns.push_back({"outcrop", "m/s2", pseudo_acceleration(outcrop, dt, periods)});
  return table;
}

/// Fourier amplitudes, on a grid of frequencies finer than the record's own: zeros follow it.
std::vector<motion::FourierAmplitude> amplitudes(std::vector<double> samples, double dt) {
  constexpr double finest = 0.05; // Hz
  samples.resize(std::max(samples.size(), static_cast<std::size_t>(1.0 / (finest * dt))), 0.0);
  return motion::fourier_spectrum(samples, dt);
}

/// Ratios of Fourier amplitudes; 0 where the denominator is below 0.02 of its largest value, which says
/// nothing.
std::vector<double> ratio(const std::vector<motion::FourierAmplitude>& above,
                          const std::vector<motion::FourierAmplitude>& below) {
  const double largest = std::ranges::max(below, {}, &motion::FourierAmplitude::amplitude).amplitude;
  std::vector<double> values;
  for (std::size_t i = 0; i < above.size(); ++i)
    values.push_back(below[i].amplitude > 0.02 * largest ? above[i].amplitude / below[i].amplitude : 0.0);
  return values;
}

results::Table transfer(const std::vector<double>& surface, const std::vector<double>& base,
                        const std::vector<double>& outcrop, double dt) {
  const auto top = amplitudes(surface, dt);
  std::vector<double> frequencies;
  frequencies.reserve(top.size());
  for (const auto& bin : top)
    frequencies.push_back(bin.frequency);
  results::Table table{
      {{"frequency", "Hz", frequencies}, {"surface_to_base", "1", ratio(top, amplitudes(base, dt))}}};
  if (!outcrop.empty())
    table.columns.push_back({"surface_to_outcrop", "1", ratio(top, amplitudes(outcrop, dt))});
  return table;
}

} // namespace

std::vector<double> outcrop_acceleration(const scene::Case& scene, const scene::SourceProcess& source,
                                         const wavefield::TimeGrid& times) {
  const auto ground = wavefield::ground_from_case(scene, scene::layers(scene, source));
  const auto incidence = wavefield::incidence_from_case(scene);
  if (scene.motion.kind == motion::MotionKind::within ||
      wavefield::is_post_critical(ground.half_space, incidence))
    return {};
  const double factor = wavefield::outcrop_factor(ground, incidence.wave, incidence.angle_rad);
  const auto signal = wavefield::incident_signal(scene, ground);
  std::vector<double> velocity;
  for (const double time : times_of(times))
    velocity.push_back(factor * (time >= signal.begin && time <= signal.end ? signal.velocity(time) : 0.0));
  return motion::differentiate(velocity, times.dt);
}

std::vector<results::NamedTable> column_tables(const scene::Case& scene, const scene::SourceProcess& source,
                                               const FreeFieldSeries& series,
                                               const std::vector<std::size_t>& shown) {
  const Member along = scene.motion.wave == scene::Wave::sv ? &ColumnSample::vx_rate : &ColumnSample::vy_rate;
  const auto surface = column_of(series.at(series.levels.size() - 1), along);
  const auto base = column_of(series.at(0), along);
  const auto outcrop = outcrop_acceleration(scene, source, series.times);
  const double dt = series.times.dt;

  std::vector<results::NamedTable> tables;
  std::vector<std::string> names;
  std::vector<double> levels;
  for (const std::size_t level : shown) {
    names.push_back(fmt::format("{:03}", names.size()));
    levels.push_back(series.levels[level]);
    tables.push_back({"/histories/" + names.back(), history(series, level)});
    if (has_pore_pressure(scene, source))
      add_water(scene, source, series, level, tables.back().table);
  }
  tables.push_back({"/levels", {{{"name", "1", names}, {"y", "m", levels}}}});
  tables.push_back({"/profile", profile(scene, source, series)});
  tables.push_back({"/spectra", spectra(surface, outcrop, dt)});
  tables.push_back({"/transfer", transfer(surface, base, outcrop, dt)});
  if (has_pore_pressure(scene, source))
    std::ranges::move(water_tables(scene, source, series), std::back_inserter(tables));
  return tables;
}

} // namespace tremolo::app
