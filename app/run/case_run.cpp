#include "app/run/case_run.hpp"

#include "app/commands.hpp"
#include "app/output_place.hpp"
#include "app/run/hosts/hosts.hpp"
#include "app/run/participant_program.hpp"
#include "app/run/run_display.hpp"
#include "app/run/run_lock.hpp"
#include "base/text/printable.hpp"
#include "base/text/text_file.hpp"
#include "coupler/launch/private_folder.hpp"
#include "coupler/process/recorded_case.hpp"
#include "coupler/recording/exchange_recorder.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "results/run_file.hpp"
#include "scene/plan/hosts.hpp"
#include "scene/plan/plan.hpp"
#include "scene/text/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

/// Places the processes that [hosts] names on their machines.
void place_elsewhere(const scene::Case& scene, const CaseRun& run, coupler::LaunchOptions& options) {
  if (run.local || scene.hosts.sides.empty())
    return;
  options.outer_endpoint = scene.hosts.endpoint;
  for (const auto& file : scene::data_files(scene))
    options.files.push_back(coupler::described(file));
  int by_slurm = 0;
  for (const auto& source : scene::plan(scene).sources)
    if (const auto* host = scene::host_of(scene, source)) {
      by_slurm += host->start == scene::StartBy::slurm ? 1 : 0;
      std::ranges::find(options.processes, source.name, &coupler::ProcessSpec::name)->elsewhere =
          elsewhere(*host, source.name, run.keys, options.deadlines.connect, by_slurm);
    }
}

/// "tremolo-wave", and who starts it where it does not run here, or as how many ranks.
std::string description(const coupler::ProcessSpec& process, const scene::Case& scene, const CaseRun& run) {
  const auto program = process.program.filename().string();
  if (process.role == coupler::Role::domain && run.ranks.count > 1)
    return fmt::format("{:<18} {}", "tremolo-domain", ranks_text(scene, run.ranks, run.local));
  if (!process.elsewhere)
    return program;
  return fmt::format("{:<18} {}", program,
                     process.elsewhere->started_by.empty() ? "by `tremolo join`"
                                                           : "by " + process.elsewhere->started_by);
}

std::vector<std::string> until_arguments(const CaseRun& run) {
  return run.until.empty() ? std::vector<std::string>{} : std::vector<std::string>{"--until", run.until};
}

/// @param shared_memory  folder for ranks
coupler::LaunchOptions launch_options(const scene::Case& scene, const CaseRun& run,
                                      const fs::path& shared_memory) {
  coupler::LaunchOptions options;
  options.case_file = scene.file;
  options.out = run.folder;
  const coupler::RunIdentity identity = identity_of(scene, run.mode);
  options.mode = identity.mode;
  options.window_steps = identity.window_steps;
  if (scene.checkpoints.keep > 0)
    options.checkpoints = {run.folder / "checkpoints", static_cast<std::size_t>(scene.checkpoints.keep),
                           identity.inputs};
  options.resume = run.resume;
  options.transport = coupler::transport_from(run.transport);
  options.keys = run.keys;
  options.deadlines = {scene.coupling.connect_deadline, scene.coupling.step_deadline,
                       scene.coupling.shutdown_deadline};
  for (const auto& source : scene::plan(scene).sources)
    options.processes.push_back({.name = source.name,
                                 .role = coupler::Role::source,
                                 .program = located(scene::program(source.field)),
                                 .arguments = own_arguments(source.field)});
  options.processes.push_back({.name = "domain",
                               .role = coupler::Role::domain,
                               .program = located("tremolo-domain"),
                               .threads = run.threads,
                               .arguments = until_arguments(run)});
  start_as_ranks(options.processes.back(), scene, run.ranks, run.local, shared_memory,
                 options.deadlines.connect);
  place_elsewhere(scene, run, options);
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

/// /timeline of the run file: what each process did when, in seconds of each slice of wall time.
results::Table timeline_table(const std::vector<coupler::ProcessSummary>& summaries) {
  std::vector<std::string> names;
  std::vector<std::string> activities;
  std::vector<double> times;
  std::vector<double> slices;
  std::vector<double> durations;
  for (const auto& summary : summaries) {
    const auto& timeline = summary.report.timeline;
    for (const auto& [activity, seconds] : timeline.activities)
      for (std::size_t i = 0; i < seconds.size(); ++i) {
        names.push_back(summary.name);
        activities.push_back(activity);
        times.push_back(timeline.slice * static_cast<double>(i));
        slices.push_back(timeline.slice);
        durations.push_back(seconds[i]);
      }
  }
  return {{{"process", "1", names},
           {"activity", "1", activities},
           {"time", "s", times},
           {"slice", "s", slices},
           {"duration", "s", durations}}};
}

/// The recorder of the exchange, if the case requests one.
std::unique_ptr<coupler::ExchangeRecorder> recorder_of(const scene::Case& scene, const CaseRun& run,
                                                       const coupler::LaunchOptions& options) {
  if (!scene.recording.exchange)
    return nullptr;
  coupler::RecorderOptions recorder{.file = run.folder / "exchange.h5",
                                    .on_full_disk = scene.recording.on_full_disk == scene::OnFullDisk::stop
                                                        ? coupler::OnFullDisk::stop
                                                        : coupler::OnFullDisk::go_on,
                                    .case_text = scene.text,
                                    .case_values = coupler::recorded_values(scene),
                                    .serves = {},
                                    .note = options.note,
                                    .resume = run.resume};
  if (run.resume && !fs::exists(run.resume->folder / coupler::recording_checkpoint)) {
    options.note("warning: the exchange was not recorded any more at the checkpoint; it is not recorded now");
    return nullptr;
  }
  for (const auto& source : scene::plan(scene).sources)
    for (const auto& served : source.serves)
      recorder.serves[source.name].emplace_back(scene::name(served.side));
  return std::make_unique<coupler::ExchangeRecorder>(std::move(recorder));
}

/// The command that continues a run that has ended early.
/// @param refused the set from which the run could not continue, if any
std::string resume_hint(const fs::path& folder, const std::optional<coupler::CheckpointSet>& refused) {
  if (has_all_results(folder))
    return fmt::format("its results were complete before that: {}", (folder / "run.h5").string());
  const auto set = coupler::find_sets(folder / "checkpoints").newest;
  const auto again = fmt::format("to begin again: tremolo run {}", (folder / "case.toml").string());
  if (!set)
    return "it has no checkpoint to go on from: " + again;
  if (refused && set->step == refused->step)
    return fmt::format("it could not go on from its newest checkpoint, {}: {}", set->folder.string(), again);
  return fmt::format("to go on from step {} ({:.6g} s): tremolo resume {}", set->step, set->time,
                     folder.string());
}

/// A domain that was killed could not say so in its file; the launcher does it for it. One that has crashed
/// had lost its memory, whatever it has written: its results do not count as complete.
void mark_aborted(const fs::path& file, const coupler::RunFailed& failure) {
  if (fs::exists(file) && (failure.domain_crashed() || results::RunReader(file).status() == "running"))
    results::mark_aborted(file, failure.what());
}

/// The warnings and notes of a process in its log.
std::vector<std::string> remarks_of(const std::string& process, const fs::path& folder) {
  std::vector<std::string> remarks;
  std::ifstream log(folder / "log" / (process + ".log"));
  for (std::string text; std::getline(log, text);)
    if (text.starts_with("warning: ") || text.starts_with("note: "))
      remarks.push_back(fmt::format("{}: {}", process, printable(text)));
  return remarks;
}

/// A run whose recording fails only at its very end fails too, unless the case lets it go on.
void finish_recording(coupler::ExchangeRecorder* recorder, const scene::Recording& recording,
                      ProgressLine& line) {
  if (recorder == nullptr)
    return;
  const auto lacking = recorder->finish(std::nullopt);
  if (!lacking)
    return;
  line.note(fmt::format("{}the recording of the exchange is not complete: {}",
                        recording.on_full_disk == scene::OnFullDisk::stop ? "" : "warning: ", *lacking));
  if (recording.on_full_disk == scene::OnFullDisk::stop)
    throw Exit{1};
}

} // namespace

bool has_all_results(const fs::path& folder) {
  const fs::path file = folder / "run.h5";
  const fs::path before = folder / "run.h5.before"; // set aside by a resumption that died
  return !fs::exists(before) && fs::exists(file) && results::RunReader(file).status() == "complete";
}

coupler::RunIdentity identity_of(const scene::Case& scene, const std::optional<std::string>& mode) {
  coupler::RunIdentity identity{
      .case_text = scene.text,
      .mode = coupler::mode_from(mode.value_or(std::string(scene::name(scene.coupling.mode)))),
      .window_steps = static_cast<std::uint32_t>(scene.coupling.window_steps)};
  const auto add = [&](const fs::path& file) {
    identity.inputs["CRC-32 of " + fs::absolute(file).string()] = coupler::text_crc(read_text_file(file));
  };
  for (const auto& [record, path] : scene.records())
    add(record->path);
  for (const auto& source : scene::plan(scene).sources)
    if (source.field.model == scene::SourceModel::recording)
      add(source.field.file);
  return identity;
}

std::vector<coupler::ProcessSummary> run_case(scene::Case scene, const CaseRun& run) {
  make_folder(run.folder);
  const RunLock lock(run.folder);
  scene.file = run.folder / "case.toml";
  if (!run.resume)
    write_text_file(scene.file, scene.text);
  std::optional<coupler::PrivateFolder> shared_memory;
  if (run.ranks.count > 1)
    shared_memory.emplace(shared_memory_parent());
  auto options = launch_options(scene, run, shared_memory ? shared_memory->path() : fs::path());
  ProgressLine line;
  options.on_progress = [&](const coupler::Progress& progress) { line.show(progress); };
  options.note = [&](const std::string& note) { line.note(note); };
  fmt::print("{}\n", scene.title);
  for (const auto& process : options.processes)
    fmt::print("  {:<12} {}\n", process.name, description(process, scene, run));
  fmt::print("results in {}, mode {}\n", run.folder.string(), coupler::name(options.mode));
  std::fflush(stdout);
  const fs::path file = run.folder / "run.h5";
  const auto recorder = recorder_of(scene, run, options);
  options.observer = recorder.get();
  try {
    auto summaries = coupler::launch(options);
    finish_recording(recorder.get(), scene.recording, line);
    results::append_table(file, "/processes", process_table(summaries));
    results::append_table(file, "/timeline", timeline_table(summaries));
    line.note("finished");
    for (const auto& process : options.processes)
      for (const auto& remark : remarks_of(process.name, run.folder))
        line.note(remark);
    return summaries;
  } catch (const coupler::RunFailed& failure) {
    line.note(failure.what());
    if (recorder)
      recorder->finish(failure.what());
    mark_aborted(file, failure);
    line.note(resume_hint(run.folder, failure.refuses_checkpoint() ? run.resume : std::nullopt));
    throw Exit{failure.exit_status()};
  }
}

} // namespace tremolo::app
