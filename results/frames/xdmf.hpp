#pragma once

// The XDMF 2 companion of a run file: a temporal collection of particle clouds whose heavy data stay in the
// HDF5 file.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace tremolo::results {

/// Description of one field of a frame for XDMF.
struct XdmfField {
  std::string name;
  std::size_t components = 1;
  bool real = true; ///< double, otherwise 32-bit integer
};

/// Collects the frames of a run and keeps the XDMF file beside it up to date.
class XdmfFile {
public:
  /// @param run_file the HDF5 file, which is written to the same folder
  explicit XdmfFile(const std::filesystem::path& run_file);

  /// Adds a frame whose fields lie in `group` of the HDF5 file, in one write over the end of the XDMF file.
  /// @throws std::runtime_error with file and reason
  void add_frame(double time, std::string_view group, std::size_t particles,
                 std::span<const XdmfField> fields);

private:
  std::filesystem::path file_;
  std::string heavy_data_; ///< name of the HDF5 file
  std::uintmax_t end_ = 0; ///< of the last frame in the file
};

} // namespace tremolo::results
