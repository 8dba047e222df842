#pragma once

// Options that the launcher passes to every participant: its command line, and the run's session in the
// environment, where other users of the machine cannot read it.
//
//     TREMOLO_SESSION=0123456789abcdef tremolo-wave --case CASE --name left --endpoint ipc:///run/...
//     [--threads N] [--out DIR] [--keys DIR]

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::coupler {

/// Every wait has a deadline, s.
struct Deadlines {
  double connect = 30.0; ///< until all participants have said HELLO
  double step = 60.0;    ///< between two signs of life of a participant that owes something
  double shutdown = 2.0; ///< between BYE and the end of the process
};

struct ParticipantOptions {
  std::filesystem::path case_file;
  std::string name;     ///< unique in the run, e.g. "left"
  std::string endpoint; ///< of the hub
  /// Random number of the run; absent in a process that does not speak to the hub itself.
  std::optional<std::uint64_t> session{};
  int threads = 1;
  std::filesystem::path out; ///< the run's folder; a participant that writes nothing ignores it
  Deadlines deadlines;
  std::filesystem::path keys;     ///< folder of CURVE keys (keys.hpp); empty: none, on this machine alone
  std::filesystem::path resume{}; ///< folder of the checkpoint from which the domain continues; empty: none
};

/// An option that a participant has beside the common ones, e.g. a source's file.
struct OwnOption {
  std::string flag; ///< "--file"
  std::string help;
  std::string& value; ///< holds the default, receives what was given
};

/// The command line for options, without the program itself.
std::vector<std::string> command_line(const ParticipantOptions& options);

/// Additions to the launcher's environment for the participant, NAME=VALUE each.
std::vector<std::string> environment(const ParticipantOptions& options);

/// @throws std::runtime_error where there is none, with the variable that should hold it
std::uint64_t session_of(const ParticipantOptions& options);

/// The body of a participant's main: reads command line and environment, runs, and turns every exception into
/// one line "program: message" on stderr.
/// @returns the process's exit status: 0, 1 for a failure, 2 for a wrong command line
int participant_main(const std::string& program, const std::string& description, int argc, char** argv,
                     const std::function<void(const ParticipantOptions&)>& body,
                     const std::vector<OwnOption>& own_options = {});

} // namespace tremolo::coupler
