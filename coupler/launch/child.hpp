#pragma once

// A participant that the launcher has started, seen from there: it works, it ends by itself, or it is ended.
// It is a process (child_process.hpp) or a thread of this process (child_thread.hpp); what it says stands in
// its log.

#include "coupler/mapping/timing.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tremolo::coupler {

class Child {
public:
  virtual ~Child() = default;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Looks, without waiting, whether it has ended.
  virtual bool ended() = 0;

  /// Ends one that is still there.
  virtual void kill() = 0;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// After the end: whether its exit status was 0.
  [[nodiscard]] virtual bool succeeded() const = 0;
  /// By kill(): it did not end by itself.
  [[nodiscard]] bool killed() const { return killed_; }
  /// How it ended: "exited with code 3", "was killed by signal 9 (Killed)", or by kill().
  [[nodiscard]] virtual std::string ending() const = 0;
  /// From start to end, s.
  [[nodiscard]] double wall_seconds() const;
  /// After the end.
  [[nodiscard]] double seconds_since_end() const { return seconds_since(end_); }
  /// User and system time, s.
  [[nodiscard]] double cpu_seconds() const { return cpu_seconds_; }
  /// The last lines it wrote.
  [[nodiscard]] std::vector<std::string> last_lines(std::size_t most) const;

protected:
  Child(std::string name, std::filesystem::path log_file);

  std::string name_;
  std::filesystem::path log_file_;
  Clock::time_point start_;
  Clock::time_point end_;
  bool killed_ = false; ///< by kill()
  double cpu_seconds_ = 0.0;
};

} // namespace tremolo::coupler
