// tremolo sbatch: the script of a Slurm job that runs a case over its nodes.

#include "app/commands.hpp"
#include "app/run/hosts/domain_ranks.hpp"
#include "scene/plan/hosts.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct SbatchArguments {
  fs::path case_file;
  fs::path keys;
  std::optional<int> ranks;
};

/// Free fields that Slurm places.
int placed_sources(const scene::Case& scene) {
  int count = 0;
  for (const auto& source : scene::plan(scene).sources)
    if (const auto* host = scene::host_of(scene, source);
        host != nullptr && host->start == scene::StartBy::slurm)
      ++count;
  return count;
}

/// Whether Slurm places the ranks, as --ranks wants it.
bool places_ranks(const scene::Case& scene, const SbatchArguments& arguments) {
  const bool by_slurm = scene.hosts.domain && scene.hosts.domain->start == scene::StartRanksBy::slurm;
  if (arguments.ranks && !by_slurm)
    throw std::runtime_error(fmt::format("--ranks {}: {} has no start = \"slurm\" in [hosts.domain]",
                                         *arguments.ranks, arguments.case_file.string()));
  if (by_slurm && !arguments.ranks)
    throw std::runtime_error(fmt::format(
        "{} has start = \"slurm\" in [hosts.domain]: say with --ranks N how many ranks share the domain",
        arguments.case_file.string()));
  return by_slurm;
}

std::string in_double_quotes(const fs::path& path) {
  std::string text;
  for (const char c : fs::absolute(path).lexically_normal().string()) {
    if (c == '"' || c == '\\' || c == '$' || c == '`')
      text += '\\';
    text += c;
  }
  return fmt::format("\"{}\"", text);
}

/// Resources that the job requests, as lines of its script and as text.
struct Request {
  std::string words;
  std::string lines;
  std::string threads; ///< of the domain or of each rank, as the job's shell knows them
};

/// A task for each rank: how many nodes that makes, and how many processors a task has, slurm_options say.
Request request_for_ranks(int ranks, int sources) {
  return {.words = fmt::format("{} ranks of the domain{}", ranks,
                               sources > 0 ? ", and the free fields beside them" : ""),
          .lines = fmt::format("#SBATCH --ntasks={}\n", ranks),
          .threads = "${SLURM_CPUS_PER_TASK:-1}"};
}

/// A node for the domain and one for each free field.
Request request_for_nodes(int sources) {
  const int count = sources + 1;
  return {.words = fmt::format("the domain on the first of {} nodes, a free field on each other one", count),
          .lines = fmt::format("#SBATCH --nodes={}\n#SBATCH --ntasks-per-node=1\n", count),
          .threads = "${SLURM_CPUS_ON_NODE:-1}"};
}

void sbatch(const SbatchArguments& arguments) {
  const auto scene = scene::load(arguments.case_file);
  const int sources = placed_sources(scene);
  const bool ranks = places_ranks(scene, arguments);
  if (sources == 0 && !ranks)
    throw std::runtime_error(
        fmt::format("{}: no side has start = \"slurm\" in [hosts]; a job on one node needs "
                    "no script but `tremolo run`",
                    arguments.case_file.string()));
  if (sources > 0 && arguments.keys.empty())
    throw std::runtime_error(
        "free fields on other nodes need --keys: a folder of CURVE keys (`tremolo keygen`) "
        "that all nodes see");
  std::string options;
  std::istringstream words(scene.hosts.slurm_options);
  for (std::string word; words >> word;)
    options += fmt::format("#SBATCH {}\n", word);
  const Request request = ranks ? request_for_ranks(*arguments.ranks, sources) : request_for_nodes(sources);
  fmt::print("#!/bin/bash\n"
             "# {}: {}.\n"
             "#SBATCH --job-name=tremolo\n"
             "{}"
             "# A minute before the time is over: files are closed in order.\n"
             "#SBATCH --signal=B:TERM@60\n"
             "{}"
             "exec {} run {}{}{} --threads \"{}\"\n",
             scene.title, request.words, request.lines, options,
             in_double_quotes(fs::read_symlink("/proc/self/exe")), in_double_quotes(arguments.case_file),
             arguments.keys.empty() ? "" : " --keys " + in_double_quotes(arguments.keys),
             ranks ? fmt::format(" --ranks {}", *arguments.ranks) : "", request.threads);
}

} // namespace

void add_sbatch(Command& app) {
  auto* command = app.add_subcommand(
      "sbatch", "Print the script of a Slurm job that runs a case with the processes that its [hosts] place "
                "by Slurm, or with ranks of the domain (docs/cluster.md)");
  const auto arguments = std::make_shared<SbatchArguments>();
  command->add_option("CASE", arguments->case_file, "Case file")->required();
  command
      ->add_option(
          "--keys", arguments->keys,
          "Folder of CURVE keys (`tremolo keygen`) that all nodes see; free fields on other nodes need them")
      ->existing_folder();
  command
      ->add_option("--ranks", arguments->ranks,
                   "Processes that share the domain, where [hosts.domain] has start = \"slurm\"")
      ->between(2, most_ranks);
  command->callback([arguments] { sbatch(*arguments); });
}

} // namespace tremolo::app
