#include "app/free_field/column/column_file.hpp"

#include "app/free_field/column/column_levels.hpp"
#include "app/free_field/column/column_warnings.hpp"
#include "app/free_field/column_report.hpp"
#include "app/free_field/series/free_field_series.hpp"
#include "app/free_field/water_tables.hpp"

#include <algorithm>
#include <variant>

namespace tremolo::app {

namespace {

using freefield::ColumnSample;

std::optional<double> surface_of_vertical(const ColumnGround& ground, const FreeFieldSeries& series) {
  if (!ground.scene.vertical)
    return std::nullopt;
  return peak(series.at(series.levels.size() - 1), &ColumnSample::vy_rate);
}

ColumnSummary summary_of(const ColumnGround& ground, const FreeFieldSeries& series) {
  const bool shear = ground.scene.motion.wave == scene::Wave::sv;
  const auto along = shear ? &ColumnSample::vx_rate : &ColumnSample::vy_rate;
  const auto strain = shear ? &ColumnSample::gxy : &ColumnSample::eyy;
  const std::size_t strained = peak_level(series, strain);
  ColumnSummary summary{.cpu_seconds = series.cpu_seconds,
                        .surface_acceleration = peak(series.at(series.levels.size() - 1), along),
                        .base_acceleration = peak(series.at(0), along),
                        .vertical_acceleration = surface_of_vertical(ground, series),
                        .largest_strain = peak(series.at(strained), strain),
                        .strain_depth = series.levels.back() - series.levels[strained],
                        .water = {},
                        .report = series.report,
                        .warnings = column_warnings(ground, series)};
  if (has_pore_pressure(ground.scene, ground.source))
    summary.water = water_summary(ground.scene, ground.source, series);
  return summary;
}

/// A table of numbers as a series, row by row.
void write_series(results::RunWriter& run, const results::NamedTable& named) {
  std::vector<std::string> names, units;
  std::vector<const std::vector<double>*> columns;
  for (const auto& column : named.table.columns) {
    names.push_back(column.name);
    units.push_back(column.unit);
    columns.push_back(&std::get<std::vector<double>>(column.values));
  }
  results::TimeSeries& series = run.add_series(named.path, names, units);
  std::vector<double> row(columns.size());
  for (std::size_t i = 0; i < columns.front()->size(); ++i) {
    std::ranges::transform(columns, row.begin(), [i](const auto* column) { return (*column)[i]; });
    series.append(row);
  }
}

void write_file(const ColumnGround& ground, const ColumnResults& found, const ColumnSummary& summary,
                const std::filesystem::path& out) {
  results::RunWriter run(out, {.title = ground.scene.title,
                               .case_text = ground.scene.text,
                               .plan = "{}",
                               .build_version = TREMOLO_VERSION,
                               .compiler = __VERSION__,
                               .build_flags = TREMOLO_BUILD_FLAGS,
                               .content = column_content});
  run.attribute("model", std::string(scene::name(ground.source.field.model)));
  run.attribute("wave", std::string(scene::name(ground.scene.motion.wave)));
  run.attribute("angle_deg", ground.scene.motion.angle_deg);
  if (ground.scene.vertical)
    run.attribute("vertical_angle_deg", ground.scene.vertical->angle_deg);
  run.attribute("cpu_time", summary.cpu_seconds);
  run.attribute("report", summary.report);
  for (const results::NamedTable& history : found.histories)
    write_series(run, history);
  for (const auto& [path, table] : found.tables)
    run.table(path, table);
  if (!summary.warnings.empty())
    run.table("/warnings", {{{"text", "1", summary.warnings}}});
  run.finish();
}

} // namespace

ColumnSummary write_column(const ColumnGround& ground, const ColumnHistories& histories,
                           const std::filesystem::path& out) {
  const auto& [scene, source, x] = ground;
  const auto depths = history_depths(ground, histories.depths);
  const auto series =
      free_field_series(scene, source, profile_levels(ground, depths),
                        column_times(ground, histories.duration, histories.every), x, TimeOf::soil);
  std::vector<std::size_t> shown;
  for (const double depth : depths) {
    // The last of equal levels: above an interface.
    const auto above = std::ranges::upper_bound(series.levels, source.surface - depth);
    shown.push_back(static_cast<std::size_t>(above - series.levels.begin()) - 1);
  }
  const ColumnSummary summary = summary_of(ground, series);
  write_file(ground, column_results(ground, series, shown), summary, out);
  return summary;
}

} // namespace tremolo::app
