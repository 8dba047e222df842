#pragma once

// A participant's process: started with its output in a log file, in a process group of its own (so that
// Ctrl-C reaches only the launcher, which then ends the run in order), killed by the kernel if the launcher
// dies.

#include "coupler/launch/child.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace tremolo::coupler {

class ChildProcess final : public Child {
public:
  /// @param command program and its arguments
  /// @param log_file receives stdout and stderr
  /// @throws Error if the program cannot be started or the log not written
  ChildProcess(std::string name, const std::vector<std::string>& command, std::filesystem::path log_file);

  /// Kills and reaps a process that is still there.
  ~ChildProcess() override;

  bool ended() override;
  /// The kernel guarantees its end, which is waited for.
  void kill() override;
  [[nodiscard]] bool succeeded() const override;
  [[nodiscard]] std::string ending() const override;

private:
  bool reap(int wait_options);

  pid_t pid_ = -1;
  std::optional<int> status_;
};

} // namespace tremolo::coupler
