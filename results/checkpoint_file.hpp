#pragma once

// The state of one participant at one step, an HDF5 file in the folder of its set:
// RUN/checkpoints/STEP/PARTICIPANT.h5 (docs/checkpoints.md). Named arrays, each chunk with a checksum.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::results {

/// Version of what the files of a set hold; a set of another version is refused.
inline constexpr std::string_view checkpoint_schema_version = "1.8";

/// Identity of the run that a checkpoint belongs to; the file is read only if all of it agrees.
struct CheckpointIdentity {
  std::string participant;
  std::string case_crc;   ///< CRC-32 of the case's text, 8 hexadecimal digits
  std::uint64_t step = 0; ///< of the domain, the next one
};

/// Passes the numbers of an array to `take`, in order, piece by piece.
template <class Number>
using GiveNumbers = std::function<void(const std::function<void(std::span<const Number> piece)>& take)>;

/// Writes a file that is on the disk when close() returns.
///
/// @throws std::runtime_error with file and reason where it cannot be written
class CheckpointWriter {
public:
  CheckpointWriter(const std::filesystem::path& file, const CheckpointIdentity& identity);
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// Names may be used once.
  void write(const std::string& name, std::span<const double> values);
  void write(const std::string& name, std::span<const std::uint64_t> values);
  void write_text(const std::string& name, std::string_view text);

  /// Write an array of `size` numbers that are made meanwhile, as if all of them were there.
  /// @throws std::invalid_argument where more come, or fewer
  void write_numbers(const std::string& name, std::size_t size, const GiveNumbers<double>& give);
  void write_integers(const std::string& name, std::size_t size, const GiveNumbers<std::uint64_t>& give);

  /// Waits until the disk has everything.
  void close();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// @throws std::runtime_error with file and reason where the file is absent, damaged, of another schema
/// version or identity (with both values), or lacks what is asked for
class CheckpointReader {
public:
  CheckpointReader(const std::filesystem::path& file, const CheckpointIdentity& expected);
  ~CheckpointReader();
  CheckpointReader(const CheckpointReader&) = delete;
  CheckpointReader& operator=(const CheckpointReader&) = delete;

  [[nodiscard]] std::vector<double> numbers(const std::string& name) const;
  [[nodiscard]] std::vector<std::uint64_t> integers(const std::string& name) const;
  /// Some of these.
  [[nodiscard]] std::vector<double> numbers(const std::string& name, std::size_t first,
                                            std::size_t count) const;
  [[nodiscard]] std::vector<std::uint64_t> integers(const std::string& name, std::size_t first,
                                                    std::size_t count) const;
  /// How many there are.
  [[nodiscard]] std::size_t size(const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& name) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Moves a file that a run which is resumed writes anew out of the way, to FILE.before, from which it takes
/// over what the checkpoint knows of; a resumption that was ended in the middle of that has left it there.
/// @returns FILE.before, to be removed when all is taken over
/// @throws std::runtime_error where there is no such file
std::filesystem::path set_aside(const std::filesystem::path& file);

/// Waits until the disk has what was written to a file, or the entries of a folder.
/// @throws std::runtime_error with path and reason
void sync_to_disk(const std::filesystem::path& path);

} // namespace tremolo::results
