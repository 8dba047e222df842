// tremolo column: the free field of a case alone, by any model, as engineers look at it.

#include "app/commands.hpp"
#include "app/free_field/column/column_ground.hpp"
#include "app/free_field/column_recording.hpp"
#include "app/free_field/column_report.hpp"
#include "app/free_field/free_field_series.hpp"
#include "app/free_field/water_tables.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "results/run_file.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/wet_soils.hpp"
#include "scene/read/override.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/soil_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::app {
namespace {

constexpr const char* column_content = "column";

struct Options {
  std::string scene;
  std::string model;
  std::string out;
  std::string record;
  std::string side;
  std::vector<double> depths;
  std::optional<double> duration;
  std::optional<double> every;
  bool plot = false;
};

scene::Side side_of(const Options& options) {
  return options.side == "right" ? scene::Side::right : scene::Side::left;
}

/// The complete case, with the model on both sides and at the base.
scene::Case with_model(const Options& options) {
  const scene::Case given = scene::load(options.scene);
  const auto text = scene::overridden_text(
      given, {.record = {}, .angle_deg = {}, .model = scene::computed_model(options.model)});
  return scene::parse(text, given.file, given.directory);
}

/// The profile of the case, for which only its tables are needed; or that of a side.
ColumnGround ground_of(const Options& options) {
  if (options.side.empty())
    return column_ground(options.scene, scene::computed_model(options.model));
  auto scene = with_model(options);
  const auto source = scene::source_of(scene::plan(scene), side_of(options));
  const double x = side_of(options) == scene::Side::left ? scene.mesh.box.x_min : scene.mesh.box.x_max;
  return {std::move(scene), source, x};
}

/// Even levels for the peak profiles, interfaces twice, and those asked for.
std::vector<double> all_levels(const scene::Case& scene, const scene::SourceProcess& source,
                               const std::vector<double>& depths) {
  constexpr int intervals = 100;
  const double base = deepest_level(scene, source);
  std::vector<double> levels;
  levels.reserve(intervals + 1 + depths.size());
  for (int i = 0; i < intervals; ++i)
    levels.push_back(base + (source.surface - base) * i / intervals);
  levels.push_back(source.surface);
  for (const double depth : depths) {
    const double y = source.surface - depth;
    if (!(y >= base && y <= source.surface))
      throw std::runtime_error(fmt::format("--depths: {} m is outside the column, allowed are 0 to {} m",
                                           depth, source.surface - base));
    if (std::ranges::find(levels, y) == levels.end())
      levels.insert(std::ranges::lower_bound(levels, y), y);
  }
  return scene::with_interfaces(std::move(levels), source.surface, scene::layers(scene, source), 0.0);
}

/// Whether two layers are slices of one soil whose properties vary over depth.
bool slices_of_one_soil(const scene::Case& scene, const scene::Layer& above, const scene::Layer& below) {
  return above.soil && below.soil && above.wet == below.wet &&
         std::ranges::any_of(scene.soil_profiles, [&](const scene::SoilProfile& soil) {
           return soil.has(*above.soil) && soil.has(*below.soil);
         });
}

/// Depths of the histories: those asked for, otherwise surface, interfaces and base. Slices of one soil have
/// no interface between them.
std::vector<double> depths_of(const scene::Case& scene, const scene::SourceProcess& source,
                              const Options& options) {
  if (!options.depths.empty())
    return options.depths;
  const std::vector<scene::Layer>& layers = scene::layers(scene, source);
  std::vector<double> depths{0.0};
  double depth = 0.0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    depth += layers[i].thickness;
    if (i + 1 == layers.size() || !slices_of_one_soil(scene, layers[i], layers[i + 1]))
      depths.push_back(depth);
  }
  return depths;
}

void print_summary(const FreeFieldSeries& series, const scene::Case& scene, const Options& options) {
  using freefield::ColumnSample;
  const bool shear = scene.motion.wave == scene::Wave::sv;
  const auto along = shear ? &ColumnSample::vx_rate : &ColumnSample::vy_rate;
  const auto strain = shear ? &ColumnSample::gxy : &ColumnSample::eyy;
  const auto largest = [&](std::size_t k, double ColumnSample::*member) {
    double value = 0.0;
    for (const ColumnSample& sample : series.at(k))
      value = std::max(value, std::abs(sample.*member));
    return value;
  };
  std::size_t weakest = 0;
  for (std::size_t k = 0; k < series.levels.size(); ++k)
    if (largest(k, strain) > largest(weakest, strain))
      weakest = k;
  fmt::print("{}: model {}, {:.2f} s CPU\n  peak acceleration  surface {:.4g} m/s2, base {:.4g} m/s2\n"
             "  largest strain     {:.3g} at {:.4g} m below the surface\n",
             options.out, options.model, series.cpu_seconds, largest(series.levels.size() - 1, along),
             largest(0, along), largest(weakest, strain), series.levels.back() - series.levels[weakest]);
}

void print_linearised(const scene::Case& scene, const scene::SourceProcess& source) {
  for (const std::string& note : scene::linearised_soils(scene, source))
    fmt::print("{}\n", note);
}

void print_strengths(const scene::Case& scene) {
  for (const auto& [name, soil] : scene::named_soils(scene))
    if (const auto compared = scene::implied_strength(soil))
      fmt::print("  {}\n", *compared);
}

void record(const Options& options) {
  const scene::Case scene = with_model(options);
  const scene::Side side = side_of(options);
  print_linearised(scene, scene::source_of(scene::plan(scene), side));
  record_column(scene, side, options.record);
  fmt::print("{}: the {} free field, model {}\n", options.record, scene::name(side), options.model);
}

void compute(const Options& options) {
  const ColumnGround ground = ground_of(options);
  const auto& [scene, source, x] = ground;
  const auto depths = depths_of(scene, source, options);
  fmt::print("{}", scene::remarks_text(scene));
  if (scene.water)
    fmt::print("{}", scene::water_text(scene));
  print_linearised(scene, source);
  const auto series =
      free_field_series(scene, source, all_levels(scene, source, depths),
                        column_times(ground, options.duration, options.every), x, TimeOf::soil);
  std::vector<std::size_t> shown;
  for (const double depth : depths) {
    // The last of equal levels: above an interface.
    const auto above = std::ranges::upper_bound(series.levels, source.surface - depth);
    shown.push_back(static_cast<std::size_t>(above - series.levels.begin()) - 1);
  }
  const auto tables = column_tables(scene, source, series, shown);
  results::write_tables(options.out, column_content, tables);
  print_summary(series, scene, options);
  if (has_pore_pressure(scene, source))
    fmt::print("{}", water_summary(scene, source, series));
  if (!series.report.empty())
    fmt::print("  {:<18} {}\n", options.model, series.report);
  if (scene.regions.empty()) // otherwise the remarks have said it
    print_strengths(scene);
  if (options.plot && run_python("column", {options.out}) != 0)
    throw Exit{1};
}

/// Whose files it reads shows only when the case is read.
void require_places(const Options& options) {
  const std::vector<std::filesystem::path> inputs{options.scene};
  if (!options.record.empty())
    return require_writable(options.record, inputs, has_content("free field"), "--record");
  const std::filesystem::path out = options.out;
  if (out.extension() != ".h5")
    throw std::runtime_error(
        fmt::format("--out {}: holds HDF5 tables, so its name must end with .h5", out.string()));
  require_writable(out, inputs, has_content(column_content));
  for (const char* ending : {".png", "_water.png"})
    if (options.plot)
      require_writable(out.parent_path() / (out.stem().string() + ending), inputs, is_picture_of_tremolo,
                       "--plot");
}

} // namespace

void add_column(Command& app) {
  auto* command = app.add_subcommand(
      "column",
      "The free field of a case alone: histories, peak profiles, spectra, transfer functions, loops");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("CASE", options->scene,
                   "Case file; needs [motion], [surface], [halfspace] and [[profile]], for mpm also [mesh]")
      ->required();
  command->add_option("--model", options->model, "Free-field model: wave, fe, ode, eql or mpm")
      ->required()
      ->one_of(scene::names_of_computed_models());
  command
      ->add_option(
          "--side", options->side,
          "left or right of a complete case: its layers and surface, at its edge of the box (default: "
          "[[profile]] under [surface], at the reference point; of a recording the left side)")
      ->one_of({"left", "right"});
  auto* out = command->add_option("--out", options->out, "Written: HDF5 tables, see docs/output-format.md");
  auto* recording =
      command
          ->add_option("--record", options->record,
                       "Written: the free field of a side of a complete case, for model = \"recording\"")
          ->excludes(out);
  command
      ->add_option("--depths", options->depths,
                   "Depths of the histories, m, separated by commas (default: surface, interfaces, base)")
      ->delimiter(',')
      ->non_negative()
      ->excludes(recording);
  command
      ->add_option(
          "--duration", options->duration,
          "End of the histories, s (default: the end of the rest; without one that of the motion and of the "
          "column's ringing)")
      ->excludes(recording);
  command
      ->add_option("--every", options->every,
                   "Time step of the histories, s (default: a quarter of the shortest period, at most 5 ms)")
      ->excludes(recording);
  command
      ->add_flag("--plot", options->plot,
                 "Draw OUT.png beside the file, and OUT_water.png of ground with pore pressure")
      ->excludes(recording);
  command->callback([options] {
    if (options->out.empty() && options->record.empty())
      throw_required("--out or --record");
    require_places(*options);
    if (options->record.empty())
      compute(*options);
    else
      record(*options);
  });
}

} // namespace tremolo::app
