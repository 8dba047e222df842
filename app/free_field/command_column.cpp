// tremolo column: the free field of a case alone, by any model, as engineers look at it.

#include "app/commands.hpp"
#include "app/free_field/column/column_file.hpp"
#include "app/free_field/column/column_models.hpp"
#include "app/free_field/column_recording.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/wet_soils.hpp"
#include "scene/random/random_text.hpp"
#include "scene/read/override.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/soil_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::app {
namespace {

struct Options {
  std::string scene;
  std::string model;
  std::vector<std::string> models;
  std::string out;
  std::string record;
  std::string side;
  ColumnHistories histories;
  bool plot = false;
};

scene::Side side_of(const Options& options) {
  return options.side == "right" ? scene::Side::right : scene::Side::left;
}

/// The complete case, with the model on both sides and at the base.
scene::Case with_model(const Options& options, scene::SourceModel model) {
  const scene::Case given = scene::load(options.scene);
  const auto text = scene::overridden_text(given, {.record = {}, .angle_deg = {}, .model = model});
  return scene::parse(text, given.file, given.directory);
}

/// The profile of the case, for which only its tables are needed; or that of a side.
ColumnGround ground_of(const Options& options, scene::SourceModel model) {
  if (options.side.empty())
    return column_ground(options.scene, model);
  auto scene = with_model(options, model);
  const auto source = scene::source_of(scene::plan(scene), side_of(options));
  const double x = side_of(options) == scene::Side::left ? scene.mesh.box.x_min : scene.mesh.box.x_max;
  return {std::move(scene), source, x};
}

void print_summary(const ColumnSummary& summary, const Options& options) {
  fmt::print("{}: model {}, {:.2f} s CPU\n  peak acceleration  surface {:.4g} m/s2, base {:.4g} m/s2{}\n"
             "  largest strain     {:.3g} at {:.4g} m below the surface\n{}",
             options.out, options.model, summary.cpu_seconds, summary.surface_acceleration,
             summary.base_acceleration,
             summary.vertical_acceleration
                 ? fmt::format(", vertical at the surface {:.4g} m/s2", *summary.vertical_acceleration)
                 : "",
             summary.largest_strain, summary.strain_depth, summary.water);
  if (!summary.report.empty())
    fmt::print("  {:<18} {}\n", options.model, summary.report);
}

void print_linearised(const scene::Case& scene, const scene::SourceProcess& source) {
  for (const std::string& note : scene::linearised_soils(scene, source))
    fmt::print("{}\n", note);
}

/// Backbones that have the strength given; others are warned of.
void print_strengths(const scene::Case& scene) {
  for (const auto& [name, soil] : scene::named_soils(scene))
    if (const auto compared = scene::implied_strength(soil); compared && compared->near)
      fmt::print("  {}\n", compared->text);
}

/// Prints what all models have alike.
void print_ground_alone(const scene::Case& scene) {
  if (scene.random_profile)
    fmt::print("{}", scene::random_profile_text(scene));
  if (scene.water)
    fmt::print("{}", scene::water_text(scene));
}

/// Prints what a user should know about a ground before it is computed.
void print_ground(const ColumnGround& ground) {
  fmt::print("{}", scene::remarks_text(ground.scene));
  print_ground_alone(ground.scene);
  print_linearised(ground.scene, ground.source);
  if (ground.scene.regions.empty()) // otherwise the remarks have said it
    print_strengths(ground.scene);
}

void record(const Options& options) {
  const scene::Case scene = with_model(options, scene::computed_model(options.model));
  const scene::Side side = side_of(options);
  print_linearised(scene, scene::source_of(scene::plan(scene), side));
  record_column(scene, side, options.record);
  fmt::print("{}: the {} free field, model {}\n", options.record, scene::name(side), options.model);
}

void compute(const Options& options) {
  const ColumnGround ground = ground_of(options, scene::computed_model(options.model));
  print_ground(ground);
  const ColumnSummary summary = write_column(ground, options.histories, options.out);
  print_summary(summary, options);
  for (const std::string& warning : summary.warnings)
    fmt::print("  warning: {}\n", warning);
  if (options.plot && run_python("column", {options.out}) != 0)
    throw Exit{1};
}

void compute_models(const Options& options) {
  const auto models = scene::computed_models(options.models);
  make_folder(options.out);
  bool said = false;
  const auto found = column_models(
      models,
      [&](scene::SourceModel model) {
        auto ground = ground_of(options, model);
        if (!said)
          print_ground_alone(ground.scene);
        said = true;
        print_linearised(ground.scene, ground.source);
        return ground;
      },
      options.histories, options.out);
  fmt::print("\n{}", models_text(found));
  if (std::ranges::none_of(found, [](const ModelOfSite& one) { return one.refused.empty(); }) ||
      run_python("site", {options.out}) != 0)
    throw Exit{1};
}

/// The files that a case reads are known only after the case has been read.
void require_places(const Options& options) {
  const std::vector<std::filesystem::path> inputs{options.scene};
  if (!options.record.empty())
    return require_writable(options.record, inputs, has_content("free field"), "--record");
  const std::filesystem::path out = options.out;
  if (!options.models.empty()) {
    std::vector<OwnFile> files{{"site.json", begins_with(models_content)}};
    for (const std::string& model : options.models)
      files.push_back({model + ".h5", has_content(column_content)});
    return require_writable_in(out, files, inputs);
  }
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
  auto* model = command->add_option("--model", options->model, "Free-field model: wave, fe, ode, eql or mpm")
                    ->one_of(scene::names_of_computed_models());
  auto* models = command
                     ->add_option("--models", options->models,
                                  "Several models, separated by commas, in one report: --out is its folder")
                     ->delimiter(',')
                     ->one_of(scene::names_of_computed_models())
                     ->excludes(model);
  command
      ->add_option(
          "--side", options->side,
          "left or right of a complete case: its layers and surface, at its edge of the box (default: "
          "[[profile]] under [surface], at the reference point; of a recording the left side)")
      ->one_of({"left", "right"});
  auto* out = command->add_option("--out", options->out,
                                  "Written: OUT.h5 of --model, or the folder of --models; see "
                                  "docs/output-format.md");
  auto* recording =
      command
          ->add_option("--record", options->record,
                       "Written: the free field of a side of a complete case, for model = \"recording\"")
          ->excludes(out)
          ->excludes(models);
  command
      ->add_option("--depths", options->histories.depths,
                   "Depths of the histories, m, separated by commas (default: surface, interfaces, base)")
      ->delimiter(',')
      ->non_negative()
      ->excludes(recording);
  command
      ->add_option(
          "--duration", options->histories.duration,
          "End of the histories, s (default: the end of the rest; without one that of the motion and of the "
          "column's ringing)")
      ->excludes(recording);
  command
      ->add_option("--every", options->histories.every,
                   "Time step of the histories, s (default: a quarter of the shortest period, at most 5 ms)")
      ->excludes(recording);
  command
      ->add_flag("--plot", options->plot,
                 "Draw OUT.png beside the file, and OUT_water.png of ground with pore pressure")
      ->excludes(recording)
      ->excludes(models);
  command->callback([options] {
    if (options->model.empty() && options->models.empty())
      throw_required("--model or --models");
    if (options->out.empty() && options->record.empty())
      throw_required("--out or --record");
    require_places(*options);
    if (!options->record.empty())
      record(*options);
    else if (options->models.empty())
      compute(*options);
    else
      compute_models(*options);
  });
}

} // namespace tremolo::app
