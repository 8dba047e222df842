// tremolo run: a case, with what the command line overrides in it.

#include "app/commands.hpp"
#include "app/free_field/motion_levels.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "app/recording/recording_name.hpp"
#include "app/run/case_run.hpp"
#include "app/run/local_options.hpp"
#include "app/run/run_display.hpp"
#include "app/run/until_stage.hpp"
#include "results/exchange_file.hpp"
#include "scene/plan/plan.hpp"
#include "scene/read/override.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct RunArguments {
  std::string case_file;
  fs::path out;
  std::optional<std::string> mode;
  std::optional<fs::path> motion;
  std::optional<double> angle_deg;
  std::vector<std::string> replays;
  std::string until;
  bool report = false;
  LocalOptions local;
};

constexpr std::array all_sides{scene::Side::left, scene::Side::right, scene::Side::base};

bool in_use(const fs::path& folder) {
  std::error_code not_reached; // by a path that leads nowhere, which make_folder() reports
  return fs::exists(folder, not_reached) && !(fs::is_directory(folder) && fs::is_empty(folder));
}

/// "slope_oblique" for slope_oblique/case.toml, "box" for box.toml.
std::string case_name(const fs::path& file) {
  const auto stem = file.stem().string();
  const auto folder = fs::absolute(file).parent_path().filename().string();
  return stem == "case" && !folder.empty() ? folder : stem;
}

/// An empty folder: the requested one, or runs/NAME, runs/NAME-2, ...
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
  make_folder(folder);
  return folder;
}

/// The recorded side that represents all sides served by its source, so that one process serves them again.
scene::Side first_side(const results::ExchangeSource& source) {
  return *std::ranges::find(all_sides, source.serves.front(), [](scene::Side side) { return name(side); });
}

/// The recording that serves each replayed side.
std::map<scene::Side, scene::RecordedSide> replays(const std::vector<std::string>& names) {
  std::map<scene::Side, scene::RecordedSide> sides;
  for (const auto& text : names) {
    const RecordingName recording = recording_named(text);
    if (!recording.side && !recording.exchange)
      throw std::invalid_argument(fmt::format("--replay {}: {} is not the recorded exchange of a run", text,
                                              recording.file.string()));
    const results::ExchangeReader exchange(recording.file);
    for (const auto side : all_sides)
      if (!recording.side || recording.side == side)
        sides[side] = {recording.file, first_side(exchange.source_of(name(side)))};
  }
  return sides;
}

void run(const RunArguments& arguments) {
  const auto given = scene::load(arguments.case_file);
  std::optional<fs::path> record = arguments.motion;
  if (record)
    record = fs::absolute(*record);
  const auto text = scene::overridden_text(given, {.record = record,
                                                   .angle_deg = arguments.angle_deg,
                                                   .model = {},
                                                   .replays = replays(arguments.replays)});
  // Refused before anything is written or started.
  const auto scene = scene::parse(text, given.file, given.directory);
  check_until(scene, arguments.until);
  check_ranks(scene, arguments.local.ranks, arguments.local.local);
  const auto folder = new_folder(arguments);
  fmt::print("  {}{}", motion_levels_text(scene), scene::remarks_text(scene));
  const auto summaries = run_case(scene, {.folder = folder,
                                          .mode = arguments.mode,
                                          .transport = arguments.local.transport,
                                          .threads = arguments.local.threads_of_domain(scene),
                                          .keys = arguments.local.keys,
                                          .local = arguments.local.local,
                                          .ranks = arguments.local.ranks,
                                          .until = arguments.until});
  fmt::print("{}results: {}\n", summary_text(summaries), (folder / "run.h5").string());
  if (arguments.report && run_python("report", {folder.string()}) != 0)
    throw Exit{EXIT_FAILURE};
}

} // namespace

void add_run(Command& app) {
  auto* command = app.add_subcommand("run", "Run a case: start its processes, watch them, and sum up");
  const auto arguments = std::make_shared<RunArguments>();
  command->add_option("CASE", arguments->case_file, "Case file")->required();
  command->add_option("--out", arguments->out,
                      "New folder for the results; without it runs/NAME, runs/NAME-2, ...");
  command
      ->add_option("--mode", arguments->mode,
                   "Exchange: window or lockstep; the same bits (default: the case's)")
      ->one_of({"window", "lockstep"});
  add_local_options(*command, arguments->local);
  command->add_option("--motion", arguments->motion, "Record to use instead of the case's")->existing_file();
  command->add_option("--angle", arguments->angle_deg, "Angle of incidence instead of the case's, degrees");
  command->add_option("--replay", arguments->replays,
                      "RUN:left, RUN:right or RUN:base: this side is served from the recorded exchange of an "
                      "earlier run instead of its model; RUN alone: all sides. Several are allowed");
  add_until_option(*command, arguments->until);
  command->add_flag("--report", arguments->report, "Write report.html beside the results at the end");
  command->callback([arguments] { run(*arguments); });
}

} // namespace tremolo::app
