// tremolo join: takes the place of one process in a run on another machine.

#include "app/commands.hpp"
#include "app/run/local_options.hpp"
#include "app/run/participant_program.hpp"
#include "app/temporary_folder.hpp"
#include "base/text/printable.hpp"
#include "base/text/text_file.hpp"
#include "coupler/launch/child_process.hpp"
#include "coupler/launch/joining.hpp"
#include "coupler/launch/termination.hpp"
#include "scene/plan/service.hpp"
#include "scene/read/override.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

/// Number of bytes of a participant's log that are shown.
constexpr std::size_t most_log_bytes = 65536;

struct JoinArguments {
  std::string endpoint;
  std::string role;
  fs::path keys;
  std::optional<fs::path> case_file;
  std::string run;
  fs::path out;
  int threads = 1;
  double deadline = 30.0;
};

void require_same_files(const coupler::Invitation& invitation) {
  std::string differences;
  for (const auto& file : invitation.files)
    if (const auto difference = coupler::difference(file))
      differences += fmt::format("{}{}", differences.empty() ? "" : "\n", *difference);
  if (!differences.empty())
    throw std::runtime_error(differences);
}

/// The participant's program and its command line, as the run itself would start it.
coupler::Command command(const JoinArguments& arguments, const coupler::Invitation& invitation,
                         const fs::path& folder) {
  const auto file = folder / "case.toml";
  write_text_file(file, invitation.case_text);
  const auto plan = scene::plan(scene::load(file));
  const auto& field = scene::source_named(plan, arguments.role).field;
  std::vector<std::string> words{located(scene::program(field)).string()};
  const auto own = own_arguments(field);
  words.insert(words.end(), own.begin(), own.end());
  const coupler::ParticipantOptions options{.case_file = file,
                                            .name = arguments.role,
                                            .endpoint = arguments.endpoint,
                                            .session = invitation.session,
                                            .threads = arguments.threads,
                                            .out = arguments.out.empty() ? folder : arguments.out,
                                            .deadlines = invitation.deadlines,
                                            .keys = arguments.keys};
  const auto common = coupler::command_line(options);
  words.insert(words.end(), common.begin(), common.end());
  return {std::move(words), coupler::environment(options)};
}

/// Until the participant has ended, or must: then why.
std::optional<std::string> watch(coupler::ChildProcess& participant, coupler::Joining& line,
                                 coupler::SignalWatch& signals, const std::string& endpoint) {
  constexpr int tick_ms = 50;
  constexpr double grace_s = 2.0; // a run that is over closes its connections while we end
  std::optional<coupler::Clock::time_point> gone;
  while (!participant.ended()) {
    pollfd signal{signals.descriptor(), POLLIN, 0};
    ::poll(&signal, 1, tick_ms);
    if (const auto number = signals.termination())
      return fmt::format("was interrupted on its machine by {}", number == SIGINT ? "Ctrl-C" : "SIGTERM");
    if (!gone && line.hub_is_gone())
      gone = coupler::Clock::now();
    if (gone && coupler::seconds_since(*gone) > grace_s)
      return fmt::format("was ended: the run at {} is gone", endpoint);
  }
  return std::nullopt;
}

void join(const JoinArguments& arguments) {
  coupler::SignalWatch signals; // before ZeroMQ's threads, which inherit the blocked signals
  std::optional<std::string> given;
  if (arguments.case_file)
    given = scene::overridden_text(scene::load(*arguments.case_file), {});
  coupler::Joining line(
      {arguments.endpoint, arguments.role, arguments.keys, arguments.run, given, arguments.deadline});
  const auto invitation = line.invitation();
  require_same_files(invitation);
  const TemporaryFolder folder;
  const auto log = folder.path() / "log";
  coupler::ChildProcess participant(arguments.role, command(arguments, invitation, folder.path()), log);
  fmt::print("'{}' takes part in the run at {}\n", arguments.role, arguments.endpoint);
  std::fflush(stdout);

  auto trouble = watch(participant, line, signals, arguments.endpoint);
  participant.kill();
  if (!trouble && !participant.succeeded())
    trouble = participant.ending();
  fmt::print("{}", printable(read_text_file(log), most_log_bytes));
  std::fflush(stdout);
  if (!trouble)
    return;
  const auto last = participant.last_lines(1);
  line.abandon(fmt::format("'{}' {}{}", arguments.role, *trouble, last.empty() ? "" : ": " + last.front()));
  throw std::runtime_error(fmt::format("'{}' {}", arguments.role, *trouble));
}

} // namespace

void add_join(Command& app) {
  auto* command = app.add_subcommand(
      "join", "Take part in a run on another machine: compute one of its free fields here (docs/cluster.md)");
  const auto arguments = std::make_shared<JoinArguments>();
  command
      ->add_option("ENDPOINT", arguments->endpoint, "Address of the run, tcp://ADDRESS:PORT, as it prints it")
      ->required();
  command->add_option("--role", arguments->role, "Which process of the run, as `tremolo explain` names them")
      ->required();
  command
      ->add_option("--keys", arguments->keys,
                   "Folder of CURVE keys with ROLE.public, ROLE.secret and hub.public")
      ->required()
      ->existing_folder();
  command
      ->add_option("--case", arguments->case_file,
                   "Case file that the run must have; without it the case is that of the run")
      ->existing_file();
  command->add_option(
      "--run", arguments->run,
      "Number of the run that is meant, 16 hexadecimal digits; without it the one that is there");
  command
      ->add_option("--out", arguments->out, "Folder for what the process writes; without it nothing is kept")
      ->existing_folder();
  command->add_option("--threads", arguments->threads, "Threads to compute with")
      ->between(1, most_threads)
      ->capture_default_str();
  command->add_option("--deadline", arguments->deadline, "How long to wait for the run, s")
      ->positive()
      ->capture_default_str();
  command->callback([arguments] { join(*arguments); });
}

} // namespace tremolo::app
