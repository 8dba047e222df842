// tremolo safety: the factor of safety of a case under its own weight, by strength reduction.

#include "app/commands.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "app/run/local_options.hpp"
#include "base/text_file.hpp"
#include "mpm_domain/gravity/strength_reduction.hpp"
#include "mpm_domain/process/spec_from_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::string case_file;
  fs::path out;
  double tolerance = 0.01;
  int threads = machine_threads();
};

constexpr const char* trials_heading = "factor,stands,unbalanced_over_applied_force\n";
constexpr const char* mechanism_heading =
    "x_m,y_m,size_m,vx_over_fastest,vy_over_fastest,equivalent_plastic_strain\n";

mpm_domain::Spec spec_of(const Options& options) {
  const auto scene = scene::load(options.case_file);
  if (!scene.gravity)
    throw std::runtime_error(
        fmt::format("{}: a factor of safety is that of soil under its weight: the case needs [gravity]",
                    options.case_file));
  auto spec = mpm_domain::spec_from_case(scene, options.threads);
  const auto soils = mpm_domain::reducible_soils(spec);
  if (soils.reduced.empty())
    throw std::runtime_error(fmt::format(
        "{}: no soil has a cohesion and a friction angle that could be reduced: a factor of safety "
        "needs model = \"mohr_coulomb\" or \"drucker_prager\"",
        options.case_file));
  fmt::print("c and tan(phi) divided by F: {}\n", fmt::join(soils.reduced, ", "));
  if (!soils.kept.empty())
    fmt::print("carry any load at rest, and keep their strength: {}\n", fmt::join(soils.kept, ", "));
  return spec;
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
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.4g},{:.4g},{:.4g}\n", point.place.x, point.place.y,
                        point.size, point.velocity.x, point.velocity.y, point.plastic_strain);
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

void find(const Options& options) {
  const auto spec = spec_of(options);
  if (!options.out.empty())
    require_place(options);
  std::vector<mpm_domain::StrengthTrial> trials;
  const auto safety = mpm_domain::factor_of_safety(spec, options.tolerance, [&](const auto& trial) {
    trials.push_back(trial);
    fmt::print("  F = {:<6.4g} {}, unbalanced over applied force {:.1e}\n", trial.factor,
               trial.stands ? "stands" : "fails ", trial.residual);
    std::fflush(stdout);
  });
  fmt::print("factor of safety {:.3g}: stands with {:.4g}, fails with {:.4g}\n", safety.stands, safety.stands,
             safety.fails);
  if (options.out.empty())
    return;
  write_text_file(options.out / "safety.csv", trials_text(trials));
  write_text_file(options.out / "mechanism.csv", mechanism_text(safety.mechanism));
  if (run_python("safety-picture", {options.out.string()}) != 0)
    throw Exit{1};
}

} // namespace

void add_safety(Command& app) {
  auto* command = app.add_subcommand(
      "safety",
      "The factor of safety of a case under its own weight, by strength reduction (docs/safety.md)");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("CASE", options->case_file,
                   "Case file with [gravity] and a soil that has cohesion and friction")
      ->required();
  command->add_option(
      "--out", options->out,
      "Folder: safety.csv with all trials, mechanism.csv and mechanism.png with the soil that fails");
  command
      ->add_option("--tolerance", options->tolerance,
                   "Largest factor that stands and smallest one that fails differ by no more, 1")
      ->between(0.001, 0.25)
      ->capture_default_str();
  command->add_option("--threads", options->threads, "Threads of the domain")
      ->between(1, most_threads)
      ->capture_default_str();
  command->callback([options] { find(*options); });
}

} // namespace tremolo::app
