#pragma once

// An array of known shape whose values come in pieces, whatever their lengths. They go to the file as whole
// chunks: HDF5 would read a chunk again, and write it to another place, if it came in two parts.

#include "results/hdf5/hdf5_write.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::results {

/// How an array lies in the file.
struct ArrayLayout {
  /// Rows of a chunk, which has a Fletcher-32 checksum; 0: all rows lie together without one, and wait for
  /// the last of them.
  hsize_t chunk_rows = 0;
  bool compressed = false; ///< chunks are shuffled and deflated
};

/// Chunks that are shuffled, deflated and checksummed, where that makes an array smaller.
/// @param bytes  of all its values
ArrayLayout compressed_layout(std::size_t bytes);

class ArrayInPieces {
public:
  /// Creates the array.
  /// @param type   of a value, in memory and in the file
  /// @param shape  rows, then the shape of a row
  ArrayInPieces(Place place, std::string_view name, hid_t type, std::span<const hsize_t> shape,
                ArrayLayout layout);

  /// Takes the next values, whole rows of them.
  /// @throws std::invalid_argument where there are more than the shape has, or parts of rows
  void add(FieldValues values);
  void add(const void* values, std::size_t count);

  /// Closes the array.
  /// @param unit  none where it is empty
  /// @throws std::invalid_argument where values are missing
  void finish(std::string_view unit);

private:
  void write_rows(const std::byte* values, hsize_t rows);

  const std::filesystem::path& file_;
  std::string name_;
  hid_t type_;
  std::vector<hsize_t> shape_;
  Handle dataset_;
  std::size_t row_size_ = 1;       ///< values of a row
  std::size_t value_bytes_ = 0;    ///< bytes of a value
  std::size_t rows_at_once_ = 0;   ///< of a chunk, or all
  std::size_t taken_ = 0;          ///< values that have come
  hsize_t written_ = 0;            ///< rows in the file
  std::vector<std::byte> pending_; ///< rows that wait for the rest of their chunk
};

/// Writes an array of `shape`; `compress` shuffles, deflates and checksums it in chunks, where that makes it
/// smaller.
void write_array(Place place, std::string_view name, std::span<const hsize_t> shape, FieldValues values,
                 std::string_view unit, bool compress);

} // namespace tremolo::results
