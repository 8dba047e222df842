#include "app/swap/swap.hpp"

#include "app/commands.hpp"
#include "app/free_field/series/free_field_series.hpp"
#include "app/study/differences.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/read/override.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace tremolo::app {

namespace {

std::optional<PorePressureRatio> ratio_at(const std::string& monitor, const results::RunReader& run,
                                          const results::RunReader& reference) {
  constexpr std::string_view column = "pore_pressure_ratio";
  const auto series = run.series("/monitors/" + monitor);
  if (!series.has(column))
    return std::nullopt;
  const auto ratios = series.column(column);
  const auto expected = reference.series("/monitors/" + monitor).column(column);
  const std::size_t rows = std::min(ratios.size(), expected.size());
  double sum = 0.0;
  Squares squares;
  for (std::size_t i = 0; i < rows; ++i) {
    sum += ratios[i];
    squares.add(ratios[i], expected[i]);
  }
  if (std::ranges::all_of(ratios, [](double ratio) { return ratio == 0.0; })) // dry, or drained
    return std::nullopt;
  const auto count = static_cast<double>(rows);
  return PorePressureRatio{sum / count, std::sqrt(squares.difference / count)};
}

/// The free fields of the sides that differ: the left one, and the right one where its ground or surface is
/// another.
using SideFields = std::vector<FreeFieldSeries>;

/// The larger of the two sides' differences.
double difference(const SideFields& fields, const SideFields& reference) {
  double worst = 0.0;
  for (std::size_t side = 0; side < fields.size(); ++side) {
    Squares squares;
    for (std::size_t i = 0; i < fields[side].samples.size(); ++i)
      for (const auto component : {&freefield::ColumnSample::vx, &freefield::ColumnSample::vy})
        squares.add(fields[side].samples[i].*component, reference[side].samples[i].*component);
    worst = std::max(worst, squares.relative());
  }
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
  std::vector<double> levels(intervals + 1, surface);
  for (int i = 0; i < intervals; ++i)
    levels[static_cast<std::size_t>(i)] = base + (surface - base) * i / intervals;
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

} // namespace

std::vector<SwappedRun> swap_models(const scene::Case& given, const std::vector<scene::SourceModel>& models,
                                    const std::filesystem::path& out, int threads) {
  std::vector<SwappedRun> swapped;
  std::optional<results::RunReader> first_run;
  std::optional<SideFields> first_fields;
  std::optional<SideFields> exact;
  for (const scene::SourceModel model : models) {
    SwappedRun& entry = swapped.emplace_back(SwappedRun{
        variant_of(given, std::string(scene::name(model)),
                   scene::overridden_text(given, {.record = {}, .angle_deg = {}, .model = model}))});
    const auto& scene = entry.variant.scene;
    if (!scene) {
      fmt::print("{}: {}\n", entry.model(), entry.variant.refused);
      continue;
    }
    print_linearised(*scene);
    const auto folder = out / entry.model();
    try {
      entry.cost = run_variant(entry.variant, folder, threads);
    } catch (const Exit& exit) {
      if (exit.status > interrupted)
        throw;
      entry.variant.refused = fmt::format("the run in {} failed, as said above", folder.string());
      entry.failed = true;
      continue;
    }
    const results::RunReader run(folder / "run.h5");
    const auto fields = side_fields(*scene, model, fmt::format("free field of {}", entry.model()));
    if (!first_run) {
      first_run.emplace(folder / "run.h5");
      first_fields = fields;
      exact = exact_fields(*scene);
    }
    for (const scene::Monitor& monitor : scene->monitors)
      entry.monitors.push_back({monitor.name, difference_at(monitor.name, run, *first_run).relative(),
                                ratio_at(monitor.name, run, *first_run)});
    if (fields && first_fields)
      entry.free_field = difference(*fields, *first_fields);
    if (fields && exact)
      entry.free_field_to_exact = difference(*fields, *exact);
  }
  return swapped;
}

std::string swap_json(const std::vector<SwappedRun>& runs) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SwappedRun& run : runs) {
    nlohmann::ordered_json entry = {
        {"model", run.model()}, {"refused", run.variant.refused}, {"failed", run.failed}};
    if (run.ran()) {
      entry["source_cpu_s"] = run.cost.sources;
      entry["domain_cpu_s"] = run.cost.domain;
      entry["wall_s"] = run.cost.wall;
      if (run.free_field)
        entry["free_field"] = *run.free_field;
      if (run.free_field_to_exact)
        entry["free_field_to_exact"] = *run.free_field_to_exact;
      for (const AtMonitor& monitor : run.monitors) {
        entry["monitors"][monitor.name] = monitor.difference;
        if (const auto& ratio = monitor.ratio)
          entry["pore_pressure_ratio"][monitor.name] = {{"mean", ratio->mean},
                                                        {"rms_difference", ratio->rms_difference}};
      }
    }
    json.push_back(std::move(entry));
  }
  return json.dump(2);
}

} // namespace tremolo::app
