// tremolo sbatch: the script of a Slurm job that runs a case over its nodes.

#include "app/commands.hpp"
#include "scene/plan/hosts.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct SbatchArguments {
  fs::path case_file;
  fs::path keys;
};

/// The domain has a node, and each process that Slurm places.
int nodes(const scene::Case& scene) {
  int count = 1;
  for (const auto& source : scene::plan(scene).sources)
    if (const auto* host = scene::host_of(scene, source);
        host != nullptr && host->start == scene::StartBy::slurm)
      ++count;
  return count;
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

void sbatch(const SbatchArguments& arguments) {
  const auto scene = scene::load(arguments.case_file);
  const int count = nodes(scene);
  if (count == 1)
    throw std::runtime_error(
        fmt::format("{}: no side has start = \"slurm\" in [hosts]; a job on one node needs "
                    "no script but `tremolo run`",
                    arguments.case_file.string()));
  std::string options;
  std::istringstream words(scene.hosts.slurm_options);
  for (std::string word; words >> word;)
    options += fmt::format("#SBATCH {}\n", word);
  fmt::print("#!/bin/bash\n"
             "# {}: the domain on the first of {} nodes, a free field on each other one.\n"
             "#SBATCH --job-name=tremolo\n"
             "#SBATCH --nodes={}\n"
             "#SBATCH --ntasks-per-node=1\n"
             "# A minute before the time is over: files are closed in order.\n"
             "#SBATCH --signal=B:TERM@60\n"
             "{}"
             "exec {} run {} --keys {} --threads \"${{SLURM_CPUS_ON_NODE:-1}}\"\n",
             scene.title, count, count, options, in_double_quotes(fs::read_symlink("/proc/self/exe")),
             in_double_quotes(arguments.case_file), in_double_quotes(arguments.keys));
}

} // namespace

void add_sbatch(Command& app) {
  auto* command = app.add_subcommand(
      "sbatch", "Print the script of a Slurm job that runs a case with the processes that its [hosts] place "
                "by Slurm (docs/cluster.md)");
  const auto arguments = std::make_shared<SbatchArguments>();
  command->add_option("CASE", arguments->case_file, "Case file")->required();
  command->add_option("--keys", arguments->keys, "Folder of CURVE keys (`tremolo keygen`) that all nodes see")
      ->required()
      ->existing_folder();
  command->callback([arguments] { sbatch(*arguments); });
}

} // namespace tremolo::app
