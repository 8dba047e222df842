#pragma once

#include <filesystem>

namespace tremolo::app {

/// A folder that disappears, with all that is in it, with the object.
class TemporaryFolder {
public:
  /// @throws std::runtime_error with the reason where none can be made
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace tremolo::app
