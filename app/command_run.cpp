// tremolo run: the case and its overrides are written into the run's folder, so that the folder says what was
// computed; then the processes of the plan are started and watched to their end.

#include "app/commands.hpp"
#include "app/run_display.hpp"
#include "coupler/launcher.hpp"
#include "results/run_file.hpp"
#include "scene/case.hpp"
#include "scene/override.hpp"
#include "scene/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct RunArguments {
  std::string case_file;
  fs::path out;
  std::optional<std::string> mode;
  std::string transport = "ipc";
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::optional<fs::path> motion;
  std::optional<double> angle_deg;
};

bool in_use(const fs::path& folder) {
  return fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder));
}

/// "slope_oblique" for slope_oblique/case.toml, "box" for box.toml.
std::string case_name(const fs::path& file) {
  const auto stem = file.stem().string();
  const auto folder = fs::absolute(file).parent_path().filename().string();
  return stem == "case" && !folder.empty() ? folder : stem;
}

/// A folder that holds nothing yet: the one asked for, or runs/NAME, runs/NAME-2, ...
fs::path new_folder(const RunArguments& arguments) {
  fs::path folder = arguments.out;
  if (folder.empty()) {
    const fs::path base = fs::path("runs") / case_name(arguments.case_file);
    folder = base;
    for (int n = 2; in_use(folder); ++n)
      folder = fmt::format("{}-{}", base.string(), n);
  } else if (in_use(folder)) {
    throw std::runtime_error(
        fmt::format("{} exists and is not an empty folder; a run does not overwrite another one: choose "
                    "another --out, or leave it out",
                    folder.string()));
  }
  fs::create_directories(folder);
  return folder;
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out)
    throw std::runtime_error(fmt::format("cannot write {}: is the disk full?", file.string()));
}

/// Our programs lie beside this one; that of a user has a path of its own.
fs::path located(const std::string& program) {
  const bool ours = program.find('/') == std::string::npos;
  return ours ? fs::read_symlink("/proc/self/exe").parent_path() / program : fs::absolute(program);
}

/// What a source is told besides the options that all participants have.
std::vector<std::string> own_arguments(const scene::FreeFieldModel& field) {
  if (field.model == scene::SourceModel::recording)
    return {"--file", fs::absolute(field.file).string()};
  return {};
}

coupler::LaunchOptions launch_options(const scene::Case& scene, const RunArguments& arguments,
                                      const fs::path& folder) {
  coupler::LaunchOptions options;
  options.case_file = scene.file;
  options.out = folder;
  options.mode = coupler::mode_from(arguments.mode.value_or(std::string(scene::name(scene.coupling.mode))));
  options.window_steps = static_cast<std::uint32_t>(scene.coupling.window_steps);
  options.transport = coupler::transport_from(arguments.transport);
  options.deadlines = {scene.coupling.connect_deadline, scene.coupling.step_deadline,
                       scene.coupling.shutdown_deadline};
  for (const auto& source : scene::plan(scene).sources)
    options.processes.push_back({.name = source.name,
                                 .role = coupler::Role::source,
                                 .program = located(scene::program(source.field)),
                                 .arguments = own_arguments(source.field)});
  options.processes.push_back(
      {"domain", coupler::Role::domain, located("tremolo-domain"), arguments.threads});
  return options;
}

/// /processes of the run file: what each process of the run took.
results::Table process_table(const std::vector<coupler::ProcessSummary>& summaries) {
  std::vector<std::string> names;
  std::vector<double> wall;
  std::vector<double> cpu;
  std::vector<double> waiting;
  for (const auto& summary : summaries) {
    names.push_back(summary.name);
    wall.push_back(summary.wall_seconds);
    cpu.push_back(summary.cpu_seconds);
    waiting.push_back(summary.report.waiting);
  }
  return {
      {{"process", "1", names}, {"wall_time", "s", wall}, {"cpu_time", "s", cpu}, {"waiting", "s", waiting}}};
}

/// A domain that was killed could not say so in its file; the launcher does it for it.
void mark_aborted(const fs::path& file, const std::string& reason) {
  if (fs::exists(file) && results::RunReader(file).status() == "running")
    results::mark_aborted(file, reason);
}

void run(const RunArguments& arguments) {
  const auto given = scene::load(arguments.case_file);
  std::optional<fs::path> record = arguments.motion;
  if (record)
    record = fs::absolute(*record);
  const auto text = scene::overridden_text(given, {.record = record, .angle_deg = arguments.angle_deg});
  // Refused before anything is written or started.
  auto scene = scene::parse(text, given.file, given.directory);

  const auto folder = new_folder(arguments);
  scene.file = folder / "case.toml";
  write_text(scene.file, text);
  auto options = launch_options(scene, arguments, folder);
  ProgressLine line;
  options.on_progress = [&](const coupler::Progress& progress) { line.show(progress); };
  options.note = [&](const std::string& note) { line.note(note); };
  fmt::print("{}\n", scene.title);
  for (const auto& process : options.processes)
    fmt::print("  {:<12} {}\n", process.name, process.program.filename().string());
  fmt::print("results in {}, mode {}\n", folder.string(), coupler::name(options.mode));
  std::fflush(stdout);
  try {
    const auto summaries = coupler::launch(options);
    results::append_table(folder / "run.h5", "/processes", process_table(summaries));
    line.note("finished");
    fmt::print("{}results: {}\n", summary_text(summaries), (folder / "run.h5").string());
  } catch (const coupler::RunFailed& failure) {
    line.note(failure.what());
    mark_aborted(folder / "run.h5", failure.what());
    throw Exit{failure.exit_status()};
  }
}

} // namespace

void add_run(CLI::App& app) {
  auto* command = app.add_subcommand("run", "Run a case: start its processes, watch them, and sum up");
  const auto arguments = std::make_shared<RunArguments>();
  command->add_option("CASE", arguments->case_file, "Case file")->required();
  command->add_option("--out", arguments->out,
                      "New folder for the results; without it runs/NAME, runs/NAME-2, ...");
  command
      ->add_option("--mode", arguments->mode,
                   "Exchange: window or lockstep; the same bits (default: the case's)")
      ->check(CLI::IsMember({"window", "lockstep"}));
  command->add_option("--transport", arguments->transport, "ipc (default) or tcp on the loopback interface")
      ->check(CLI::IsMember({"ipc", "tcp"}));
  command->add_option("--threads", arguments->threads, "Threads of the domain; results do not depend on it")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--motion", arguments->motion, "Record to use instead of the case's")
      ->check(CLI::ExistingFile);
  command->add_option("--angle", arguments->angle_deg, "Angle of incidence instead of the case's, degrees");
  command->callback([arguments] { run(*arguments); });
}

} // namespace tremolo::app
