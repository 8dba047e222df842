#include "app/free_field/column_report.hpp"

#include "app/free_field/column/site_tables.hpp"
#include "app/free_field/water_tables.hpp"
#include "motion/measures.hpp"
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

std::vector<double> times_of(const wavefield::TimeGrid& grid) {
  std::vector<double> times;
  for (std::size_t i = 0; i < grid.count; ++i)
    times.push_back(grid.start + static_cast<double>(i) * grid.dt);
  return times;
}

results::Table history(const ColumnGround& ground, const FreeFieldSeries& series, std::size_t level) {
  const auto samples = series.at(level);
  results::Table table{{{"time", "s", times_of(series.times)}}};
  const auto add = [&](const char* name, const char* unit, Member member, double offset = 0.0) {
    auto values = column_of(samples, member);
    for (double& value : values)
      value += offset;
    table.columns.push_back({name, unit, std::move(values)});
  };
  add("x", "m", &ColumnSample::ux, ground.x);
  add("y", "m", &ColumnSample::uy, series.levels[level]);
  add("ux", "m", &ColumnSample::ux);
  add("uy", "m", &ColumnSample::uy);
  add("vx", "m/s", &ColumnSample::vx);
  add("vy", "m/s", &ColumnSample::vy);
  add("ax", "m/s2", &ColumnSample::vx_rate);
  add("ay", "m/s2", &ColumnSample::vy_rate);
  add("sxx", "Pa", &ColumnSample::sxx);
  add("syy", "Pa", &ColumnSample::syy);
  add("sxy", "Pa", &ColumnSample::sxy);
  add("gxy", "1", &ColumnSample::gxy);
  add("eyy", "1", &ColumnSample::eyy);
  return table;
}

/// Largest displacement relative to the base.
double relative_peak(const FreeFieldSeries& series, std::size_t level, Member member) {
  double largest = 0.0;
  for (std::size_t i = 0; i < series.times.count; ++i)
    largest = std::max(largest, std::abs(series.at(level)[i].*member - series.at(0)[i].*member));
  return largest;
}

results::Table profile(const scene::Case& scene, const scene::SourceProcess& source,
                       const FreeFieldSeries& series) {
  results::Table table{{{"y", "m", series.levels}}};
  const auto add_values = [&](const char* name, const char* unit, const auto& value) {
    std::vector<double> values;
    for (std::size_t k = 0; k < series.levels.size(); ++k)
      values.push_back(value(k));
    table.columns.push_back({name, unit, std::move(values)});
  };
  const auto add = [&](const char* name, const char* unit, Member member) {
    add_values(name, unit, [&](std::size_t k) { return peak(series.at(k), member); });
  };
  add("peak_ax", "m/s2", &ColumnSample::vx_rate);
  add("peak_ay", "m/s2", &ColumnSample::vy_rate);
  add("peak_vx", "m/s", &ColumnSample::vx);
  add("peak_vy", "m/s", &ColumnSample::vy);
  add("peak_ux", "m", &ColumnSample::ux);
  add("peak_uy", "m", &ColumnSample::uy);
  add_values("peak_ux_relative", "m",
             [&](std::size_t k) { return relative_peak(series, k, &ColumnSample::ux); });
  add_values("peak_uy_relative", "m",
             [&](std::size_t k) { return relative_peak(series, k, &ColumnSample::uy); });
  add("peak_gxy", "1", &ColumnSample::gxy);
  add("peak_eyy", "1", &ColumnSample::eyy);
  add("peak_sxy", "Pa", &ColumnSample::sxy);
  const auto effective = [&](std::size_t k) {
    return initial_effective_stress(scene, source, series.levels[k]);
  };
  const auto stress_ratio = [&](std::size_t k) {
    return effective(k) > 0.0 ? peak(series.at(k), &ColumnSample::sxy) / effective(k) : 0.0;
  };
  // Even cycles of this share of the largest stress do as much as the motion (Seed & Idriss 1971).
  constexpr double even_cycles = 0.65;
  add_values("effective_stress", "Pa", effective);
  add_values("stress_ratio", "1", stress_ratio);
  add_values("cyclic_stress_ratio", "1", [&](std::size_t k) { return even_cycles * stress_ratio(k); });
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

/// @param vertical  of the surface; empty without [motion.vertical]
results::Table spectra(const std::vector<double>& surface, const std::vector<double>& vertical,
                       const std::vector<double>& outcrop, double dt) {
  constexpr double shortest = 0.01; // s
  constexpr double longest = 10.0;  // s
  const auto periods = motion::tabulated_periods(std::max(shortest, 2.0 * dt), longest, 120);
  results::Table table{
      {{"period", "s", periods}, {"surface", "m/s2", pseudo_acceleration(surface, dt, periods)}}};
  if (!vertical.empty())
    table.columns.push_back({"surface_vertical", "m/s2", pseudo_acceleration(vertical, dt, periods)});
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

std::vector<double> amplitudes_of(const std::vector<motion::FourierAmplitude>& spectrum) {
  std::vector<double> values;
  for (const auto& bin : spectrum)
    values.push_back(bin.amplitude);
  return values;
}

results::Table transfer(const std::vector<double>& surface, const std::vector<double>& base,
                        const std::vector<double>& outcrop, double dt) {
  const auto top = amplitudes(surface, dt);
  const auto bottom = amplitudes(base, dt);
  std::vector<double> frequencies;
  frequencies.reserve(top.size());
  for (const auto& bin : top)
    frequencies.push_back(bin.frequency);
  results::Table table{{{"frequency", "Hz", frequencies},
                        {"surface_to_base", "1", ratio(top, bottom)},
                        {"surface", "m/s", amplitudes_of(top)},
                        {"base", "m/s", amplitudes_of(bottom)}}};
  if (outcrop.empty())
    return table;
  const auto rock = amplitudes(outcrop, dt);
  table.columns.push_back({"surface_to_outcrop", "1", ratio(top, rock)});
  table.columns.push_back({"outcrop", "m/s", amplitudes_of(rock)});
  return table;
}

/// A row a motion.
results::Table measures_table(const std::vector<std::string>& places,
                              const std::vector<std::vector<double>>& accelerations, double dt) {
  std::vector<motion::Measures> rows;
  for (const auto& acceleration : accelerations)
    rows.push_back(motion::measures(acceleration, dt));
  results::Table table{{{"place", "1", places}}};
  const auto add = [&](const char* name, const char* unit, double motion::Measures::*member) {
    std::vector<double> values;
    for (const auto& row : rows)
      values.push_back(row.*member);
    table.columns.push_back({name, unit, std::move(values)});
  };
  add("pga", "m/s2", &motion::Measures::pga);
  add("pgv", "m/s", &motion::Measures::pgv);
  add("arias", "m/s", &motion::Measures::arias);
  add("duration_5_75", "s", &motion::Measures::duration_5_75);
  add("duration_5_95", "s", &motion::Measures::significant_duration);
  add("cav", "m/s", &motion::Measures::cav);
  add("mean_period", "s", &motion::Measures::mean_period);
  return table;
}

} // namespace

std::vector<double> outcrop_acceleration(const scene::Case& scene, const scene::SourceProcess& source,
                                         const wavefield::TimeGrid& times) {
  const auto ground = wavefield::ground_from_case(scene, scene::layers(scene, source));
  const auto incidence = wavefield::incidence_of(scene.motion);
  if (scene.motion.kind == motion::MotionKind::within ||
      wavefield::is_post_critical(ground.half_space, incidence))
    return {};
  const double factor = wavefield::outcrop_factor(ground, incidence.wave, incidence.angle_rad);
  const auto signal = wavefield::incident_signal(scene.motion, ground);
  const auto velocity = [&](double time) {
    return time >= signal.begin && time <= signal.end ? signal.velocity(time) : 0.0;
  };
  // So near to each other that the slope is that of the signal, whose period is eight of the steps or more.
  const double near = times.dt / 16.0;
  std::vector<double> acceleration;
  for (const double time : times_of(times))
    acceleration.push_back(factor * (velocity(time + near) - velocity(time - near)) / (2.0 * near));
  return acceleration;
}

std::string place_name(double depth) {
  return depth == 0.0 ? "surface" : fmt::format("{} m", std::round(1e3 * depth) / 1e3);
}

ColumnResults column_results(const ColumnGround& ground, const FreeFieldSeries& series,
                             const std::vector<std::size_t>& shown) {
  const auto& [scene, source, x] = ground;
  const Member along = scene.motion.wave == scene::Wave::sv ? &ColumnSample::vx_rate : &ColumnSample::vy_rate;
  const auto surface = column_of(series.at(series.levels.size() - 1), along);
  const auto vertical = scene.vertical
                            ? column_of(series.at(series.levels.size() - 1), &ColumnSample::vy_rate)
                            : std::vector<double>();
  const auto base = column_of(series.at(0), along);
  const auto outcrop = outcrop_acceleration(scene, source, series.times);
  const double dt = series.times.dt;
  const bool wet = has_pore_pressure(scene, source);

  ColumnResults found;
  std::vector<std::string> names, places;
  std::vector<double> levels;
  std::vector<std::vector<double>> motions;
  if (!outcrop.empty()) {
    places.emplace_back("outcrop");
    motions.push_back(outcrop);
  }
  for (const std::size_t level : shown) {
    names.push_back(place_name(source.surface - series.levels[level]));
    levels.push_back(series.levels[level]);
    places.push_back(names.back());
    motions.push_back(column_of(series.at(level), along));
    if (scene.vertical) {
      places.push_back(names.back() + ", vertical");
      motions.push_back(column_of(series.at(level), &ColumnSample::vy_rate));
    }
    found.histories.push_back({"/monitors/" + names.back(), history(ground, series, level)});
    if (wet)
      add_water(scene, source, series, level, found.histories.back().table);
  }
  found.tables = {{"/levels", {{{"name", "1", names}, {"y", "m", levels}}}},
                  {"/profile", profile(scene, source, series)},
                  {"/spectra", spectra(surface, vertical, outcrop, dt)},
                  {"/transfer", transfer(surface, base, outcrop, dt)},
                  {"/measures", measures_table(places, motions, dt)}};
  std::ranges::move(site_tables(ground, series), std::back_inserter(found.tables));
  if (wet)
    std::ranges::move(water_tables(scene, source, series), std::back_inserter(found.tables));
  return found;
}

} // namespace tremolo::app
