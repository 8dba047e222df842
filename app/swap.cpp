#include "app/swap.hpp"

#include "app/commands.hpp"
#include "scene/errors.hpp"
#include "scene/layers.hpp"
#include "scene/override.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

std::size_t column_named(const results::SeriesData& series, const std::string& name) {
  const auto found = std::ranges::find(series.columns, name);
  if (found == series.columns.end())
    throw std::runtime_error(fmt::format("a monitor has no column '{}'", name));
  return static_cast<std::size_t>(found - series.columns.begin());
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

double difference(const FreeFieldSeries& field, const FreeFieldSeries& reference) {
  Squares squares;
  for (std::size_t i = 0; i < field.samples.size(); ++i) {
    squares.add(field.samples[i].vx, reference.samples[i].vx);
    squares.add(field.samples[i].vy, reference.samples[i].vy);
  }
  return squares.ratio();
}

/// The left free field, from base to surface.
FreeFieldSeries left_field(const scene::Case& scene, const scene::FreeFieldModel& model) {
  constexpr int intervals = 20;
  constexpr double dt = 0.005; // s
  const double surface = scene.boundary.left.surface;
  const double base = scene.mesh.box.y_min;
  std::vector<double> levels;
  levels.reserve(intervals + 1);
  for (int i = 0; i < intervals; ++i)
    levels.push_back(base + (surface - base) * i / intervals);
  levels.push_back(surface);
  scene::SourceProcess source{.name = "left", .field = model, .surface = surface};
  if (!scene.boundary.left.own_profile.empty())
    source.profile = scene::Side::left;
  const auto count = static_cast<std::size_t>(scene.shaking.duration / dt) + 1;
  return free_field_series(scene, source, std::move(levels), {0.0, dt, count}, scene.mesh.box.x_min);
}

bool is_linear(const scene::Case& scene) {
  return std::ranges::none_of(scene::layers(scene, scene.boundary.left), [&](const scene::Layer& layer) {
    return layer.soil && !std::holds_alternative<materials::LinearElastic>(scene.soils[*layer.soil].law);
  });
}

/// Where the case can be computed by plane waves.
std::optional<FreeFieldSeries> exact_field(const scene::Case& scene) {
  if (!is_linear(scene) || scene.damping.model == scene::DampingModel::rayleigh)
    return std::nullopt;
  return left_field(scene, {scene::SourceModel::wave, {}});
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

} // namespace

std::vector<SwappedRun> swap_models(const scene::Case& given, const std::vector<scene::SourceModel>& models,
                                    const CaseRun& run) {
  std::vector<SwappedRun> swapped;
  std::optional<results::RunReader> first_run;
  std::optional<FreeFieldSeries> first_field;
  std::optional<FreeFieldSeries> exact;
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
    auto field = left_field(*scene, scene->boundary.left.field);
    if (!first_run) {
      first_run.emplace(one.folder / "run.h5");
      first_field = field;
      exact = exact_field(*scene);
    }
    for (const scene::Monitor& monitor : scene->monitors)
      entry.monitors.push_back(at_monitor(monitor.name, reader, *first_run));
    entry.free_field = difference(field, *first_field);
    if (exact)
      entry.free_field_to_exact = difference(field, *exact);
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
                     scene::name(first->model));
}

std::string swap_json(const std::vector<SwappedRun>& runs) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SwappedRun& run : runs) {
    nlohmann::ordered_json entry = {{"model", scene::name(run.model)}, {"refused", run.refused}};
    if (run.refused.empty()) {
      entry["source_cpu_s"] = run.source_cpu_seconds;
      entry["domain_cpu_s"] = run.domain_cpu_seconds;
      entry["wall_s"] = run.wall_seconds;
      entry["free_field"] = *run.free_field;
      if (run.free_field_to_exact)
        entry["free_field_to_exact"] = *run.free_field_to_exact;
      for (const Difference& monitor : run.monitors)
        entry["monitors"][monitor.where] = monitor.relative_l2;
    }
    json.push_back(std::move(entry));
  }
  return json.dump(2);
}

} // namespace tremolo::app
