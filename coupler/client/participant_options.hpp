#pragma once

// The command line that every participant has: what the launcher passes to it.
//
//     tremolo-wave --case CASE --name left --endpoint ipc:///run/... --session 0123456789abcdef [--threads N]
//     [--out DIR] [--keys DIR]

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace zmq {
class context_t;
}

namespace tremolo::coupler {

/// Every wait has a deadline, s.
struct Deadlines {
  double connect = 30.0; ///< until all participants have said HELLO
  double step = 60.0;    ///< between two signs of life of a participant that owes something
  double shutdown = 2.0; ///< between BYE and the end of the process
};

/// What a participant has of the process it runs in: one of its own, or a thread beside all others of its
/// run.
struct Surroundings {
  std::shared_ptr<zmq::context_t> context{}; ///< of the hub, in one process with it; empty: one of its own
  std::FILE* log = stdout;    ///< what it has to say, by lines; "warning: ..." is shown at the end
  std::FILE* errors = stderr; ///< why it fails
};

struct ParticipantOptions {
  std::filesystem::path case_file;
  std::string name;          ///< unique in the run, e.g. "left"
  std::string endpoint;      ///< of the hub
  std::uint64_t session = 0; ///< random number of the run
  int threads = 1;
  std::filesystem::path out; ///< the run's folder; a participant that writes nothing ignores it
  Deadlines deadlines;
  std::filesystem::path keys;     ///< folder of CURVE keys (keys.hpp); empty: none, on this machine alone
  std::filesystem::path resume{}; ///< folder of the checkpoint that the domain goes on from; empty: none
  Surroundings surroundings{};
};

/// An option that a participant has beside the common ones, e.g. a source's file.
struct OwnOption {
  std::string flag; ///< "--file"
  std::string help;
  std::string& value; ///< holds the default, receives what was given
};

/// The command line for options, without the program itself.
std::vector<std::string> command_line(const ParticipantOptions& options);

/// The words of a main's command line, its program first.
using CommandLine = std::vector<std::string>;

/// The main of a participant, for a process of its own or a thread.
using ParticipantMain = std::function<int(const CommandLine&, const Surroundings&)>;

/// The body of a participant's main: parses the command line, runs, and turns every exception into one line
/// "program: message" among the errors.
/// @returns the process's exit status: 0, 1 for a failure, 2 for a wrong command line
int participant_main(const std::string& program, const std::string& description, const CommandLine& command,
                     const Surroundings& surroundings,
                     const std::function<void(const ParticipantOptions&)>& body,
                     const std::vector<OwnOption>& own_options = {});

/// The same for a program's own main, which has its process to itself.
int participant_main(const std::string& program, const std::string& description, int argc, char** argv,
                     const std::function<void(const ParticipantOptions&)>& body,
                     const std::vector<OwnOption>& own_options = {});

} // namespace tremolo::coupler
