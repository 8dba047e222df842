#pragma once

// Checksums of what a run file holds, so that a resumed run, which copies it, notices any damage. A
// checkpoint keeps those of the file as it was then (docs/checkpoints.md): one for every series and every
// dataset of /boundary over the numbers that it had, one for every group of fields in /frames and beside it.

#include "results/run_data.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::results {

/// The array of a checkpoint that holds them as text.
inline constexpr std::string_view checksums_name = "output.checksums";

/// The checksum of a dataset that grows, or of a group of fields, which is written once.
struct Checksum {
  std::string path;
  std::size_t numbers = 0; ///< from the beginning, which it is taken over
  std::uint32_t crc = 0;   ///< CRC-32

  /// Goes on over the numbers that follow.
  void add(std::span<const double> values);

  friend bool operator==(const Checksum&, const Checksum&) = default;
};

/// Checksum of a series before its first row, over the names and units of its columns.
Checksum checksum_of_series(std::string_view path, std::span<const std::string> columns,
                            std::span<const std::string> units);

/// Checksum of the fields at one time, over the time and the names, units, components, types and values, in
/// the order of names, while the values pass by.
class FieldsChecksum {
public:
  FieldsChecksum(std::string_view path, double time);

  /// Begins the next field in the order of names.
  /// @param count  values that it has
  void begin(std::string_view name, std::string_view unit, std::size_t components, bool integers,
             std::size_t count);
  /// Goes on over values of that field.
  void add(FieldValues values);

  const Checksum& checksum() const { return checksum_; }

private:
  Checksum checksum_;
};

/// The checksum of fields whose values are all here, in any order.
Checksum checksum_of_fields(std::string_view path, double time, std::span<const Field> fields);

/// A line each: CRC-32, count of numbers, path.
std::string checksum_text(std::span<const Checksum> checksums);
/// @throws std::runtime_error where the text is none of checksum_text()
std::vector<Checksum> checksums_from(std::string_view text);

/// Reads all that the checksums are of. It is to be done in a process of its own: the library may crash on a
/// damaged file.
/// @throws std::exception naming the dataset that cannot be read, or is not as it was
void require_undamaged(const std::filesystem::path& file, std::span<const Checksum> checksums);

} // namespace tremolo::results
