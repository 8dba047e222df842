#pragma once

// A participant's process: started with its output in a log file, in a process group of its own (so that
// Ctrl-C reaches only the launcher, which then ends the run in order), killed by the kernel if the launcher
// dies.

#include "coupler/timing.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace tremolo::coupler {

class ChildProcess {
public:
  /// @param command program and its arguments
  /// @param log_file receives stdout and stderr
  /// @throws Error if the program cannot be started or the log not written
  ChildProcess(std::string name, const std::vector<std::string>& command, std::filesystem::path log_file);

  /// Kills and reaps a process that is still there.
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Looks, without waiting, whether the process has ended.
  bool ended();

  /// Kills a process that is still there and waits for its end, which the kernel guarantees.
  void kill();

  [[nodiscard]] const std::string& name() const { return name_; }
  /// After the end: whether it was exit code 0.
  [[nodiscard]] bool succeeded() const;
  /// By kill(): it did not end by itself.
  [[nodiscard]] bool killed() const { return killed_; }
  /// How it ended: "exited with code 3", "was killed by signal 9 (Killed)", or by kill().
  [[nodiscard]] std::string ending() const;
  /// From start to end, s.
  [[nodiscard]] double wall_seconds() const;
  /// After the end.
  [[nodiscard]] double seconds_since_end() const { return seconds_since(end_); }
  /// User and system time, s.
  [[nodiscard]] double cpu_seconds() const { return cpu_seconds_; }
  /// The last lines it wrote.
  [[nodiscard]] std::vector<std::string> last_lines(std::size_t most) const;

private:
  bool reap(int wait_options);

  std::string name_;
  std::filesystem::path log_file_;
  pid_t pid_ = -1;
  Clock::time_point start_;
  std::optional<int> status_;
  bool killed_ = false; ///< by kill()
  Clock::time_point end_;
  double cpu_seconds_ = 0.0;
};

} // namespace tremolo::coupler
