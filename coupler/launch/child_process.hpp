#pragma once

// A participant's process: started with its output in a log file, in a process group of its own (so that
// Ctrl-C reaches only the launcher, which then ends the run in order), killed by the kernel if the launcher
// dies.

#include "coupler/mapping/timing.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace tremolo::coupler {

/// Command by which a process is started.
struct Command {
  std::vector<std::string> words;         ///< program and its arguments
  std::vector<std::string> environment{}; ///< NAME=VALUE each, beside our own environment
};

class ChildProcess {
public:
  /// @param log_file receives stdout and stderr
  /// @throws Error if the program cannot be started or the log not written
  ChildProcess(std::string name, const Command& command, std::filesystem::path log_file);

  /// Kills and reaps a process that is still there.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Looks, without waiting, whether it has ended.
  bool ended();

  /// Ends one that is still there. The kernel guarantees its end, which is waited for.
  void kill();

  [[nodiscard]] const std::string& name() const { return name_; }
  /// After the end: whether its exit status was 0.
  [[nodiscard]] bool succeeded() const;
  /// Whether kill() ended the process.
  [[nodiscard]] bool killed() const { return killed_; }
  /// After the end: whether a signal that was not ours ended it, or one that its exit code reports (mpirun).
  [[nodiscard]] bool crashed() const;
  /// A text on its end: "exited with code 3", "was killed by signal 9 (Killed)", or by kill().
  [[nodiscard]] std::string ending() const;
  /// Time from start to end, s.
  [[nodiscard]] double wall_seconds() const;
  /// After the end.
  [[nodiscard]] double seconds_since_end() const { return seconds_since(end_); }
  /// User and system time, s.
  [[nodiscard]] double cpu_seconds() const { return cpu_seconds_; }
  /// The last lines it wrote, as they may be shown on a terminal.
  [[nodiscard]] std::vector<std::string> last_lines(std::size_t most) const;

private:
  bool reap(int wait_options);

  std::string name_;
  std::filesystem::path log_file_;
  Clock::time_point start_;
  Clock::time_point end_;
  pid_t pid_ = -1;
  std::optional<int> status_;
  bool killed_ = false; ///< by kill()
  double cpu_seconds_ = 0.0;
};

} // namespace tremolo::coupler
