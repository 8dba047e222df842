#pragma once

#include <filesystem>

namespace tremolo::app {

/// Holds a run's folder, so that no two runs write into it. The processes of the run inherit it: the folder
/// is free when the last of them has ended, however they did.
class RunLock {
public:
  /// Waits a little for processes that are about to end.
  /// @throws std::runtime_error if the folder stays in use
  explicit RunLock(const std::filesystem::path& folder);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

private:
  int descriptor_;
};

} // namespace tremolo::app
