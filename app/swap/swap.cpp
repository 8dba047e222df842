#include "app/swap/swap.hpp"

#include "app/commands.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/read/override.hpp"
#include "scene/text/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace tremolo::app {

namespace {

/// Sums of squares of a difference and of its reference.
struct Squares {
  double difference = 0.0;
  double reference = 0.0;

  void add(double value, double expected) {
    difference += (value - expected) * (value - expected);
    reference += expected * expected;
  }
  double ratio() const { return reference > 0.0 ? std::sqrt(difference / reference) : 0.0; }
};

std::optional<std::size_t> find_column(const results::SeriesData& series, std::string_view name) {
  const auto found = std::ranges::find(series.columns, name);
  if (found == series.columns.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - series.columns.begin());
}

std::size_t column_named(const results::SeriesData& series, const std::string& name) {
  const auto column = find_column(series, name);
  if (!column)
    throw std::runtime_error(fmt::format("a monitor has no column '{}'", name));
  return *column;
}

Difference at_monitor(const std::string& monitor, const results::RunReader& run,
                      const results::RunReader& reference) {
  const auto series = run.series("/monitors/" + monitor);
  const auto expected = reference.series("/monitors/" + monitor);
  Squares squares;
  for (const char* name : {"vx", "vy"}) {
    const std::size_t column = column_named(series, name);
    const std::size_t stride = series.columns.size();
    for (std::size_t i = 0; i < std::min(series.rows(), expected.rows()); ++i)
      squares.add(series.values[i * stride + column], expected.values[i * stride + column]);
  }
  return {monitor, squares.ratio()};
}

std::optional<PorePressureRatio> ratio_at_monitor(const std::string& monitor, const results::RunReader& run,
                                                  const results::RunReader& reference) {
  const auto series = run.series("/monitors/" + monitor);
  const auto expected = reference.series("/monitors/" + monitor);
  const auto column = find_column(series, "pore_pressure_ratio");
  const std::size_t rows = std::min(series.rows(), expected.rows());
  if (!column || rows == 0)
    return std::nullopt;
  const std::size_t stride = series.columns.size();
  double sum = 0.0;
  double largest = 0.0;
  Squares squares;
  for (std::size_t i = 0; i < rows; ++i) {
    const double ratio = series.values[i * stride + *column];
    sum += ratio;
    largest = std::max(largest, std::abs(ratio));
    squares.add(ratio, expected.values[i * stride + *column]);
  }
  if (largest == 0.0) // dry, or drained
    return std::nullopt;
  const auto count = static_cast<double>(rows);
  return PorePressureRatio{monitor, sum / count, std::sqrt(squares.difference / count)};
}

/// The free fields of the sides that differ: the left one, and the right one where its ground or surface is
/// another.
using SideFields = std::vector<FreeFieldSeries>;

double difference(const FreeFieldSeries& field, const FreeFieldSeries& reference) {
  Squares squares;
  for (std::size_t i = 0; i < field.samples.size(); ++i) {
    squares.add(field.samples[i].vx, reference.samples[i].vx);
    squares.add(field.samples[i].vy, reference.samples[i].vy);
  }
  return squares.ratio();
}

/// The larger of the two sides' differences.
double difference(const SideFields& fields, const SideFields& reference) {
  double worst = 0.0;
  for (std::size_t i = 0; i < fields.size(); ++i)
    worst = std::max(worst, difference(fields[i], reference[i]));
  return worst;
}

std::vector<scene::Side> different_sides(const scene::Case& scene) {
  if (!scene.boundary.has_lateral_fields())
    return {scene::Side::base};
  if (scene.boundary.has_equal_sides())
    return {scene::Side::left};
  return {scene::Side::left, scene::Side::right};
}

/// The free field of a side under a model, from base to surface.
FreeFieldSeries side_field(const scene::Case& scene, scene::SourceProcess source, double x,
                           scene::SourceModel model) {
  constexpr int intervals = 20;
  constexpr double dt = 0.005; // s
  const double surface = source.surface;
  const double base = scene.mesh.box.y_min;
  std::vector<double> levels;
  levels.reserve(intervals + 1);
  for (int i = 0; i < intervals; ++i)
    levels.push_back(base + (surface - base) * i / intervals);
  levels.push_back(surface);
  const auto count = static_cast<std::size_t>(scene.end() / dt) + 1;
  source.field = {model, {}};
  return free_field_series(scene, source, std::move(levels), {0.0, dt, count}, x);
}

/// The free fields under a model; none, and the reason is said, where it cannot compute them.
std::optional<SideFields> side_fields(const scene::Case& scene, scene::SourceModel model,
                                      std::string_view what) {
  const scene::Plan plan = scene::plan(scene);
  try {
    SideFields fields;
    for (const scene::Side side : different_sides(scene)) {
      const double x = side == scene::Side::right ? scene.mesh.box.x_max : scene.mesh.box.x_min;
      fields.push_back(side_field(scene, scene::source_of(plan, side), x, model));
    }
    return fields;
  } catch (const std::exception& error) {
    fmt::print("{}: not known, {}\n", what, error.what());
    return std::nullopt;
  }
}

bool is_linear(const scene::Case& scene, const std::vector<scene::Layer>& layers) {
  return std::ranges::none_of(layers, [&](const scene::Layer& layer) {
    return layer.soil &&
           materials::traits(scene.soils[*layer.soil].law).response != materials::Response::elastic;
  });
}

/// The exact fields, if the case can be computed by plane waves.
std::optional<SideFields> exact_fields(const scene::Case& scene) {
  const auto& [sides, left, right, base] = scene.boundary;
  if (!is_linear(scene, scene::layers(scene, left)) || !is_linear(scene, scene::layers(scene, right)) ||
      (scene.damping.model == scene::DampingModel::rayleigh && scene.is_oblique()))
    return std::nullopt;
  return side_fields(scene, scene::SourceModel::wave, "exact free field");
}

/// Says which soil the model takes as linear elastic.
void print_linearised(const scene::Case& scene) {
  for (const scene::SourceProcess& source : scene::plan(scene).sources)
    for (const std::string& note : scene::linearised_soils(scene, source))
      fmt::print("{}\n", note);
}

/// Exit statuses above this one are 128 + the signal by which the user ended the run.
constexpr int interrupted = 128;

void add_costs(const std::vector<coupler::ProcessSummary>& processes, SwappedRun& entry) {
  for (const auto& process : processes) {
    (process.name == "domain" ? entry.domain_cpu_seconds : entry.source_cpu_seconds) += process.cpu_seconds;
    entry.wall_seconds = std::max(entry.wall_seconds, process.wall_seconds);
  }
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// r_u at the monitors, a line a model; empty where there is no pore pressure.
std::string ratio_text(const std::vector<SwappedRun>& runs, const SwappedRun& first) {
  if (first.pore_pressure_ratio.empty())
    return {};
  const auto width = [](const PorePressureRatio& ratio) {
    return std::max<std::size_t>(18, ratio.where.size() + 3);
  };
  std::string text = fmt::format("\n{:<10}", "r_u");
  for (const PorePressureRatio& ratio : first.pore_pressure_ratio)
    text += fmt::format("{:>{}}", ratio.where, width(ratio));
  text += '\n';
  for (const SwappedRun& run : runs) {
    if (!run.refused.empty())
      continue;
    text += fmt::format("{:<10}", scene::name(run.model));
    for (const PorePressureRatio& ratio : run.pore_pressure_ratio)
      text += fmt::format("{:>{}}", fmt::format("{:.3f} ({:.3f})", ratio.mean, ratio.rms_difference),
                          width(ratio));
    text += '\n';
  }
  return text + fmt::format("Mean of the run, in brackets the root mean square of the difference to '{}'.\n",
                            scene::name(first.model));
}

} // namespace

std::vector<SwappedRun> swap_models(const scene::Case& given, const std::vector<scene::SourceModel>& models,
                                    const CaseRun& run) {
  std::vector<SwappedRun> swapped;
  std::optional<results::RunReader> first_run;
  std::optional<SideFields> first_fields;
  std::optional<SideFields> exact;
  for (const scene::SourceModel model : models) {
    SwappedRun& entry = swapped.emplace_back(SwappedRun{.model = model});
    std::optional<scene::Case> scene;
    try {
      const auto text = scene::overridden_text(given, {.record = {}, .angle_deg = {}, .model = model});
      scene = scene::parse(text, given.file, given.directory);
    } catch (const scene::CaseErrors& errors) {
      entry.refused = errors.errors().front().message();
      fmt::print("{}: {}\n", scene::name(model), entry.refused);
      continue;
    }
    print_linearised(*scene);
    CaseRun one = run;
    one.folder = run.folder / std::string(scene::name(model));
    try {
      add_costs(run_case(*scene, one), entry);
    } catch (const Exit& exit) {
      if (exit.status > interrupted)
        throw;
      entry.refused = fmt::format("the run in {} failed, as said above", one.folder.string());
      entry.failed = true;
      continue;
    }
    const results::RunReader reader(one.folder / "run.h5");
    const auto fields = side_fields(*scene, model, fmt::format("free field of {}", scene::name(model)));
    if (!first_run) {
      first_run.emplace(one.folder / "run.h5");
      first_fields = fields;
      exact = exact_fields(*scene);
    }
    for (const scene::Monitor& monitor : scene->monitors) {
      entry.monitors.push_back(at_monitor(monitor.name, reader, *first_run));
      if (const auto ratio = ratio_at_monitor(monitor.name, reader, *first_run))
        entry.pore_pressure_ratio.push_back(*ratio);
    }
    if (fields && first_fields)
      entry.free_field = difference(*fields, *first_fields);
    if (fields && exact)
      entry.free_field_to_exact = difference(*fields, *exact);
  }
  return swapped;
}

std::string swap_text(const std::vector<SwappedRun>& runs) {
  const auto percent = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.3f} %", 100.0 * *value) : std::string("-");
  };
  const auto width = [](const Difference& monitor) {
    return std::max<std::size_t>(14, monitor.where.size() + 3);
  };
  const auto first = std::ranges::find_if(runs, [](const SwappedRun& run) { return run.refused.empty(); });
  if (first == runs.end())
    return "no model can compute this case\n";
  std::string text = fmt::format("{:<10}{:>12}{:>12}{:>12}{:>14}{:>14}", "model", "source CPU", "domain CPU",
                                 "wall", "free field", "to exact");
  for (const Difference& monitor : first->monitors)
    text += fmt::format("{:>{}}", monitor.where, width(monitor));
  text += '\n';
  for (const SwappedRun& run : runs) {
    text += fmt::format("{:<10}", scene::name(run.model));
    if (!run.refused.empty()) {
      text += fmt::format("  {}: {}\n", run.failed ? "failed" : "refused", first_line(run.refused));
      continue;
    }
    text += fmt::format("{:>10.2f} s{:>10.2f} s{:>10.2f} s{:>14}{:>14}", run.source_cpu_seconds,
                        run.domain_cpu_seconds, run.wall_seconds, percent(run.free_field),
                        percent(run.free_field_to_exact));
    for (const Difference& monitor : run.monitors)
      text += fmt::format("{:>{}}", percent(monitor.relative_l2), width(monitor));
    text += '\n';
  }
  return text +
         fmt::format("Differences: relative L2 of particle velocity, to '{}' where nothing else is said.\n",
                     scene::name(first->model)) +
         ratio_text(runs, *first);
}

std::string swap_json(const std::vector<SwappedRun>& runs) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SwappedRun& run : runs) {
    nlohmann::ordered_json entry = {{"model", scene::name(run.model)}, {"refused", run.refused}};
    if (run.refused.empty()) {
      entry["source_cpu_s"] = run.source_cpu_seconds;
      entry["domain_cpu_s"] = run.domain_cpu_seconds;
      entry["wall_s"] = run.wall_seconds;
      if (run.free_field)
        entry["free_field"] = *run.free_field;
      if (run.free_field_to_exact)
        entry["free_field_to_exact"] = *run.free_field_to_exact;
      for (const Difference& monitor : run.monitors)
        entry["monitors"][monitor.where] = monitor.relative_l2;
      for (const PorePressureRatio& ratio : run.pore_pressure_ratio)
        entry["pore_pressure_ratio"][ratio.where] = {{"mean", ratio.mean},
                                                     {"rms_difference", ratio.rms_difference}};
    }
    json.push_back(std::move(entry));
  }
  return json.dump(2);
}

} // namespace tremolo::app
