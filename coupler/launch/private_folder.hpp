#pragma once

#include <filesystem>

namespace tremolo::coupler {

/// A fresh folder of mode 0700 that is removed at the end. It holds a file that its owner locks: what a
/// killed process has left is recognised by its free lock, and removed by the next one that makes a folder
/// there.
class PrivateFolder {
public:
  /// @throws Error if the folder cannot be made
  explicit PrivateFolder(const std::filesystem::path& parent);
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Length of such a folder's path, bytes.
  static std::size_t length(const std::filesystem::path& parent);

private:
  std::filesystem::path path_;
  int lock_ = -1;
};

} // namespace tremolo::coupler
