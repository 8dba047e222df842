#pragma once

// Overhead of tables in an HDF5 file, for their writers and for estimates before a run. The overheads are
// those of libhdf5 1.10, rounded up from files that it wrote.

#include <algorithm>
#include <cstddef>

namespace tremolo {

/// A chunk of this many numbers: its index node then holds 64 chunks, some 4 million numbers, before it must
/// split.
inline constexpr std::size_t chunk_numbers = 65536;
inline constexpr std::size_t fewest_chunk_rows = 64;
inline constexpr std::size_t most_chunk_rows = 1024;

/// Rows of a chunk of a table that grows by rows.
/// @param row_size  numbers of a row
constexpr std::size_t rows_of_chunk(std::size_t row_size) {
  return std::clamp(chunk_numbers / std::max<std::size_t>(row_size, 1), fewest_chunk_rows, most_chunk_rows);
}

/// Bytes of a table that has grown to so many rows. It takes whole chunks, the first from its beginning on.
/// @param columns  numbers of a row
/// @param name     bytes of a column's name and unit
constexpr double growing_table_bytes(std::size_t columns, std::size_t rows, std::size_t name = 0) {
  constexpr std::size_t header = 3000;
  constexpr std::size_t index_of_chunk = 64;
  const std::size_t chunk = rows_of_chunk(columns);
  const std::size_t chunks = std::max<std::size_t>(1, (rows + chunk - 1) / chunk);
  return static_cast<double>(header + columns * name + chunks * (8 * columns * chunk + index_of_chunk));
}

/// Bytes of an array that is worth a chunk: the index of chunks takes 2.6 kB in the file.
inline constexpr std::size_t fewest_chunk_bytes = 8192;

/// Bytes of an array that is written once, besides its values.
/// @param bytes  of its values
constexpr double array_overhead_bytes(double bytes) {
  constexpr double header = 900.0;
  constexpr double index = 2600.0;
  return bytes < static_cast<double>(fewest_chunk_bytes) ? header : header + index;
}

} // namespace tremolo
