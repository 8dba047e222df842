#pragma once

// Starts the participants of a run, carries their messages (hub.hpp), and watches them: all end well, or all
// end. A participant that dies, or that fails a deadline, ends the run at once with one message that names
// it.

#include "coupler/client/participant_options.hpp"
#include "coupler/hub/hub.hpp"
#include "coupler/launch/run_endpoint.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/mode.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::coupler {

/// The way in which a process is started on another machine.
struct Elsewhere {
  std::string started_by; ///< "ssh to node2", "srun"; empty: the user, to whom the run prints the command
  /// The words of the command that starts it, for the hub's address and the run's number.
  std::function<std::vector<std::string>(const std::string& endpoint, const std::string& run)> command;
};

/// A process to start. It gets its own arguments, then the command line of ParticipantOptions; one that is
/// elsewhere learns all that from the hub (invitation.hpp).
struct ProcessSpec {
  std::string name;
  Role role = Role::source;
  std::filesystem::path program;
  int threads = 1;
  std::vector<std::string> arguments{};
  std::vector<std::string> environment{}; ///< NAME=VALUE each, beside the run's own
  std::optional<Elsewhere> elsewhere{};
};

struct LaunchOptions {
  std::filesystem::path case_file;
  std::filesystem::path out; ///< the run's folder, which exists; logs go to out/log/NAME.log
  std::vector<ProcessSpec> processes;
  Mode mode = Mode::window;
  std::uint32_t window_steps = default_window_steps;
  Transport transport = Transport::ipc;
  std::filesystem::path keys{};  ///< folder of CURVE keys for tcp; empty: none
  std::string outer_endpoint{};  ///< where processes from elsewhere connect, with keys; empty: there are none
  std::vector<DataFile> files{}; ///< that the case names: those from elsewhere must have the same
  Deadlines deadlines;
  std::function<void(const Progress&)> on_progress; ///< called several times a second
  std::function<void(const std::string&)> note;     ///< one line about something that does not end the run
  ExchangeObserver* observer = nullptr;             ///< none, or one that outlives the run
  CheckpointOptions checkpoints{};
  std::optional<CheckpointSet> resume{}; ///< none: from the beginning
};

struct ProcessSummary {
  std::string name;
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0; ///< NaN of a process on another machine
  ParticipantReport report;
};

struct FailureCircumstances {
  bool refuses_checkpoint = false;
  bool domain_crashed = false;
};

/// The run did not end well; the text names the culprit, how it ended and its last lines.
class RunFailed : public Error {
public:
  RunFailed(const std::string& text, int exit_status, FailureCircumstances circumstances = {})
      : Error(text), exit_status_(exit_status), circumstances_(circumstances) {}
  /// Exit status for the shell: 1, or 128 + signal if the user interrupted the run.
  [[nodiscard]] int exit_status() const { return exit_status_; }
  /// Whether it failed over the checkpoint that it was to go on from.
  [[nodiscard]] bool refuses_checkpoint() const { return circumstances_.refuses_checkpoint; }
  /// Whether a signal has ended the domain: nobody knows then what its results are worth.
  [[nodiscard]] bool domain_crashed() const { return circumstances_.domain_crashed; }

private:
  int exit_status_;
  FailureCircumstances circumstances_;
};

/// Runs all processes to their end. On Ctrl-C or SIGTERM all are asked to close their files; a second Ctrl-C
/// kills them.
/// @throws RunFailed when no process is left; Error if the run cannot be set up
std::vector<ProcessSummary> launch(const LaunchOptions& options);

} // namespace tremolo::coupler
