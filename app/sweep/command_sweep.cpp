// tremolo sweep: a case with many values of its keys.

#include "app/commands.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "app/run/hosts/domain_ranks.hpp"
#include "app/run/local_options.hpp"
#include "app/run/run_lock.hpp"
#include "app/sweep/sweep_plan.hpp"
#include "motion/make/recipe.hpp"
#include "motion/read/write.hpp"
#include "scene/text/errors.hpp"

#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct Options {
  fs::path study;
  fs::path out;
  std::optional<int> jobs;
  std::optional<std::string> slurm;
  DomainRanks ranks; ///< of each run
};

/// "slope_angles" for slope_angles.toml, "slope_oblique" for slope_oblique/sweep.toml.
std::string study_name(const fs::path& file) {
  const auto stem = file.stem().string();
  const auto folder = fs::absolute(file).parent_path().filename().string();
  return stem == "sweep" && !folder.empty() ? folder : stem;
}

/// The recipe of a study's motions.
motion::SynthesisRecipe noise_recipe(const scene::Study& study) {
  const auto& [file, count, place] = *study.motions;
  scene::Findings findings(study.file.string());
  try {
    const auto recipe = motion::read_recipe(file);
    if (const auto* noise = std::get_if<motion::SynthesisRecipe>(&recipe.what))
      return *noise;
    findings.add(
        "motions.recipe", place,
        fmt::format("{}: a pulse has no seed: write [target], [filter] and [envelope]", file.string()));
  } catch (const motion::RecordError& error) {
    findings.add("motions.recipe", place, error.what());
  }
  findings.throw_if_any();
  return {};
}

/// Makes the motions of a study, motions/seed_N.AT2, as values of an axis.
scene::Axis made_motions(const scene::Study& study, const fs::path& folder) {
  motion::SynthesisRecipe recipe = noise_recipe(study);
  const fs::path motions = fs::absolute(folder / "motions").lexically_normal();
  make_folder(motions);
  scene::Axis axis{.key = std::string(scene::record_key), .place = study.motions->place};
  for (int i = 0; i < study.motions->count; ++i) {
    const auto made = motion::synthesise(recipe);
    const fs::path file = motions / fmt::format("seed_{}.AT2", made.recipe.seed);
    require_writable(file, {}, is_written_motion);
    motion::write_record(made.record, file, {"SYNTHETIC MOTION", fmt::format("SEED {}", made.recipe.seed)});
    axis.values.push_back({fmt::format("\"{}\"", file.string()),
                           fmt::format("\"{}\"", file.filename().string()), study.motions->place});
    recipe.seed = made.recipe.seed + 1;
  }
  return axis;
}

/// Refuses ranks for runs that have no domain, and those that cannot be started, before anything is written.
/// @throws std::runtime_error, std::invalid_argument
void require_ranks(const Options& options, const scene::Study& study, const scene::Case& given) {
  if (options.ranks.count == 1)
    return;
  if (!study.models.empty())
    throw std::invalid_argument(
        fmt::format("--ranks {}: {} computes site responses, which have no domain to share: leave it out",
                    options.ranks.count, study.file.string()));
  if (!options.slurm)
    check_ranks(given, options.ranks, true);
}

void sweep(const Options& options) {
  const auto study = scene::load_study(options.study);
  const auto given = case_of(study);
  require_monitors(study, given);
  auto axes = study.axes;
  // A wrong recipe is refused before anything is written.
  if (study.motions)
    noise_recipe(study);
  auto runs = planned_runs(study, axes, given);
  require_ranks(options, study, given);

  const fs::path folder = options.out.empty() ? fs::path("sweeps") / study_name(options.study) : options.out;
  make_folder(folder);
  const RunLock lock(folder);
  require_writable_in(folder,
                      {{"sweep.json", has_words("\n \"study\": ")},
                       {"sweep.csv", begins_with("run,")},
                       {"sweep.h5", has_content("sweep")},
                       {"sweep.png", is_picture_of_tremolo},
                       {"histories.png", is_picture_of_tremolo},
                       {"spectra.png", is_picture_of_tremolo},
                       {"amplification.png", is_picture_of_tremolo},
                       {"profiles.png", is_picture_of_tremolo}},
                      {options.study, study.case_file});
  if (study.motions) {
    axes.insert(axes.begin(), made_motions(study, folder));
    runs = planned_runs(study, axes, given);
  }
  write_plan(study, axes, given, runs, folder);
  std::vector<std::string> arguments{folder.string(), "--tremolo",
                                     fs::read_symlink("/proc/self/exe").string()};
  if (options.jobs)
    arguments.insert(arguments.end(), {"--jobs", fmt::format("{}", *options.jobs)});
  if (options.ranks.count > 1)
    arguments.insert(arguments.end(), {"--ranks", fmt::format("{}", options.ranks.count)});
  if (options.slurm)
    arguments.push_back(fmt::format("--slurm={}", *options.slurm));
  std::signal(SIGINT, SIG_IGN); // Ctrl-C reaches Python too, which ends the runs and says how to go on
  if (const int status = run_python("sweep-runs", arguments); status != 0)
    throw Exit{status};
}

} // namespace

void add_sweep(Command& app) {
  auto* command = app.add_subcommand(
      "sweep",
      "Run a case with many motions, angles, soils: a table and pictures of the responses; goes on where it "
      "was interrupted (docs/sweeps.md)");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("STUDY", options->study, "Study: a case, and the values of its keys (docs/sweep-file.md)")
      ->required();
  command->add_option(
      "--out", options->out,
      "Folder of the sweep (default: sweeps/NAME). Runs that have ended well there are not made again");
  command
      ->add_option("--jobs", options->jobs,
                   "Runs at a time (default: as many as there are cores, or ranks fit on them)")
      ->between(1, most_threads);
  command
      ->add_option("--ranks", options->ranks.count,
                   "Processes that share the domain of each run, by MPI; results do not depend on it")
      ->between(1, most_ranks)
      ->capture_default_str();
  command->add_option(
      "--slurm", options->slurm,
      "OPTIONS of sbatch, such as \"--partition=short --time=2:00:00\": the runs are a job array of "
      "Slurm, at most --jobs at a time where that is given");
  command->callback([options] { sweep(*options); });
}

} // namespace tremolo::app
