// tremolo safety: the factor of safety of a case at rest, by strength reduction.

#include "app/commands.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "app/run/local_options.hpp"
#include "app/safety/static_stage.hpp"
#include "base/text/text_file.hpp"
#include "mpm_domain/gravity/held_soil.hpp"
#include "mpm_domain/gravity/strength_reduction.hpp"
#include "mpm_domain/process/spec_from_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

constexpr int below_floor = 1;

struct Options {
  std::string case_file;
  std::string stage;
  std::vector<double> from, to;
  std::optional<double> floor;
  fs::path out;
  double tolerance = 0.01;
  int threads = machine_threads();
};

/// Between which the soil may fail.
struct Ends {
  Vector from, to;
};

std::optional<Ends> ends_of(const Options& options) {
  if (options.from.empty())
    return std::nullopt;
  return Ends{{options.from[0], options.from[1]}, {options.to[0], options.to[1]}};
}

constexpr const char* trials_heading = "factor,stands,unbalanced_over_applied_force\n";
constexpr const char* mechanism_heading =
    "x_m,y_m,size_m,vx_over_fastest,vy_over_fastest,equivalent_plastic_strain\n";

scene::Case case_of(const Options& options) {
  auto scene = scene::load(options.case_file);
  if (!scene.gravity)
    throw std::invalid_argument(
        fmt::format("{}: a factor of safety is that of soil under its weight: the case needs a [[stage]] of "
                    "kind = \"gravity\"",
                    options.case_file));
  return scene;
}

void require_in_soil(const mpm_domain::Ground& ground, const char* option, Vector point) {
  if (const double away = mpm_domain::distance_to_soil(ground, point); away > ground.spec.cell_size)
    throw std::invalid_argument(
        fmt::format("{} {:g},{:g}: the nearest soil is {:.3g} m away; give a point in "
                    "it or on its surface, m",
                    option, point.x, point.y, away));
}

/// The model in which only the soil between two points may fail.
mpm_domain::Spec between(const mpm_domain::Spec& spec, const Ends& ends) {
  const mpm_domain::Ground ground(spec);
  require_in_soil(ground, "--from", ends.from);
  require_in_soil(ground, "--to", ends.to);
  const auto [x_min, x_max] = std::minmax(ends.from.x, ends.to.x);
  if (!(x_max - x_min >= 4.0 * spec.cell_size))
    throw std::invalid_argument(
        fmt::format("--from and --to are {:.3g} m apart horizontally: soil that fails between them needs at "
                    "least four cells, {:.3g} m",
                    x_max - x_min, 4.0 * spec.cell_size));
  return mpm_domain::held_beside(spec, x_min, x_max);
}

mpm_domain::Spec spec_of(const Options& options, const scene::Case& scene) {
  const auto spec = mpm_domain::spec_from_case(scene, options.threads);
  if (mpm_domain::reducible_soils(spec).reduced.empty())
    throw std::invalid_argument(
        fmt::format("{}: no soil has a strength that could be reduced: docs/safety.md lists the models of "
                    "soil that have one",
                    options.case_file));
  const auto ends = ends_of(options);
  return ends ? between(spec, *ends) : spec;
}

/// Says what the trials are made with.
void announce(const std::string& stage, const mpm_domain::Spec& spec, const std::optional<Ends>& ends) {
  const auto soils = mpm_domain::reducible_soils(spec);
  fmt::print("factor of safety at the end of stage '{}'\n", stage);
  fmt::print("strength divided by F: {}\n", fmt::join(soils.reduced, ", "));
  if (ends)
    fmt::print("only soil between x = {:g} and {:g} m may fail\n", std::min(ends->from.x, ends->to.x),
               std::max(ends->from.x, ends->to.x));
  if (!soils.kept.empty())
    fmt::print("carry any load at rest: {}\n", fmt::join(soils.kept, ", "));
}

std::string trials_text(const std::vector<mpm_domain::StrengthTrial>& trials) {
  std::string text = trials_heading;
  for (const auto& trial : trials)
    text += fmt::format("{:.6g},{},{:.3g}\n", trial.factor, trial.stands ? 1 : 0, trial.residual);
  return text;
}

std::string mechanism_text(const std::vector<mpm_domain::MovingPoint>& mechanism) {
  std::string text = mechanism_heading;
  for (const auto& point : mechanism)
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.4g},{:.4g},{:.4g}\n", point.position.x, point.position.y,
                        point.size, point.velocity.x, point.velocity.y, point.plastic_strain);
  return text;
}

/// A sentence on the result of the trials.
std::string answer(const mpm_domain::FactorOfSafety& safety) {
  if (safety.stands && safety.fails)
    return fmt::format("factor of safety {:.3g}: stands with {:.4g}, fails with {:.4g}\n", *safety.stands,
                       *safety.stands, *safety.fails);
  if (safety.stands == mpm_domain::largest_factor)
    return fmt::format("nothing fails: the ground stands with its strength divided by {:g}\n",
                       *safety.stands);
  if (safety.fails == mpm_domain::least_factor)
    return fmt::format("factor of safety below {:g}: the ground fails with {:g} times its strength, so that "
                       "it is not strength that it lacks\n",
                       *safety.fails, 1.0 / *safety.fails);
  if (safety.stands)
    return fmt::format("factor of safety at least {0:g}: stands with {0:g}\n", *safety.stands);
  return fmt::format("factor of safety below {0:g}: fails with {0:g}\n", *safety.fails);
}

/// A text on the position of the failing soil, and its interpretation.
std::string position_of_failure(const mpm_domain::FactorOfSafety& safety, double cell_size,
                             const std::optional<Ends>& ends) {
  std::string text;
  if (!safety.structures.empty())
    text = fmt::format("soil and friction do not hold {}\n", fmt::join(safety.structures, ", "));
  const auto extent = mpm_domain::extent_of(safety.mechanism);
  if (!extent)
    return text;
  text += fmt::format("the soil that fails lies between x = {:.3g} and {:.3g} m, down to {:.2g} m below the "
                      "surface\n",
                      extent->x_min, extent->x_max, extent->depth);
  if (ends)
    for (const Vector end : {ends->from, ends->to})
      if (std::min(std::abs(extent->x_min - end.x), std::abs(extent->x_max - end.x)) < cell_size)
        text += fmt::format("it ends at {:g},{:g}: with that point farther out the factor may be smaller\n",
                            end.x, end.y);
  return text;
}

void require_place(const Options& options) {
  make_folder(options.out);
  require_writable_in(options.out,
                      {{"safety.csv", begins_with(trials_heading)},
                       {"mechanism.csv", begins_with(mechanism_heading)},
                       {"mechanism.png", is_picture_of_tremolo}},
                      {options.case_file});
}

/// If nothing fails, the mechanism of an earlier call is removed as well.
void write(const Options& options, const std::vector<mpm_domain::StrengthTrial>& trials,
           const mpm_domain::FactorOfSafety& safety) {
  write_text_file(options.out / "safety.csv", trials_text(trials));
  fs::remove(options.out / "mechanism.csv");
  fs::remove(options.out / "mechanism.png");
  if (safety.mechanism.empty())
    return;
  write_text_file(options.out / "mechanism.csv", mechanism_text(safety.mechanism));
  std::vector<std::string> arguments{options.out.string()};
  if (const auto ends = ends_of(options)) {
    arguments.push_back(fmt::format("--from={},{}", ends->from.x, ends->from.y));
    arguments.push_back(fmt::format("--to={},{}", ends->to.x, ends->to.y));
  }
  if (run_python("safety-picture", arguments) != 0)
    throw std::runtime_error("the picture of the mechanism could not be made, see above");
}

void find(const Options& options) {
  const auto scene = case_of(options);
  const std::string stage = options.stage.empty() ? last_static_stage(scene) : options.stage;
  const auto spec = spec_of(options, at_end_of(scene, stage));
  if (!options.out.empty())
    require_place(options);
  announce(stage, spec, ends_of(options));
  std::vector<mpm_domain::StrengthTrial> trials;
  const auto progress = [&](const mpm_domain::StrengthTrial& trial) {
    trials.push_back(trial);
    fmt::print("  F = {:<6.4g} {}, unbalanced over applied force {:.1e}{}\n", trial.factor,
               trial.stands ? "stands" : "fails ", trial.residual, trial.ravels ? ", its skin ravels" : "");
    std::fflush(stdout);
  };
  const auto safety = options.floor ? mpm_domain::try_factor(spec, *options.floor, progress)
                                    : mpm_domain::factor_of_safety(spec, options.tolerance, progress);
  fmt::print("{}", answer(safety));
  if (safety.fails)
    fmt::print("{}", position_of_failure(safety, spec.cell_size, ends_of(options)));
  if (!options.out.empty())
    write(options, trials, safety);
  if (options.floor && safety.fails)
    throw Exit{below_floor};
}

/// Leaves the status of a factor below the floor to that.
void find_or_refuse(const Options& options) {
  try {
    find(options);
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "tremolo: %s\n", error.what());
    throw Exit{refused};
  }
}

} // namespace

void add_safety(Command& app) {
  auto* command = app.add_subcommand(
      "safety", "The factor of safety of a case at rest, by strength reduction (docs/safety.md)");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("CASE", options->case_file,
                   "Case file with a gravity stage and a soil that has a strength")
      ->required();
  command->add_option(
      "--stage", options->stage,
      "Stage at whose end, by its name: gravity, a construction or a load (default: the last of them)");
  auto* from =
      command->add_option("--from", options->from, "X,Y, m: only soil between this point and --to may fail")
          ->expected(2)
          ->delimiter(',');
  auto* to = command->add_option("--to", options->to, "X,Y, m: the other end")->expected(2)->delimiter(',');
  from->needs(to);
  to->needs(from);
  auto* floor =
      command
          ->add_option("--floor", options->floor,
                       "Only say whether the factor of safety is at least this, by a single trial, 1")
          ->between(mpm_domain::least_factor, mpm_domain::largest_factor);
  command->add_option(
      "--out", options->out,
      "Folder: safety.csv with all trials, mechanism.csv and mechanism.png with the soil that fails");
  command
      ->add_option("--tolerance", options->tolerance,
                   "Largest factor that stands and smallest one that fails differ by no more, 1")
      ->between(0.001, 0.25)
      ->capture_default_str()
      ->excludes(floor);
  command->add_option("--threads", options->threads, "Threads of the domain")
      ->between(1, most_threads)
      ->capture_default_str();
  command->footer(
      "Ends with 0 where the question has an answer, with 1 where --floor is given and the factor is "
      "below it, and with 2 where the case has no factor of safety.");
  command->callback([options] { find_or_refuse(*options); });
}

} // namespace tremolo::app
