#pragma once

// A dataset that grows by rows: [rows, ...]. A plain one is not compressed, so that a chunk keeps its place
// in the file when it fills up; rows that the file declares but whose values never arrived (an empty dataset
// has one) read as NaN. A packed one is compressed and checksummed chunk by chunk: it is to be given whole
// chunks, and declares only rows that were written.

#include "results/hdf5/hdf5_write.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace tremolo::results {

enum class Storage {
  plain,
  packed ///< shuffled, deflated, with a Fletcher-32 checksum
};

class GrowingDataset {
public:
  /// Creates an empty dataset whose rows have the shape `row_shape` (empty: one number a row).
  /// @param chunk_rows rows of a chunk; 0: as many as are good for a dataset of its own
  GrowingDataset(Place place, std::string_view name, std::span<const hsize_t> row_shape,
                 Storage storage = Storage::plain, hsize_t chunk_rows = 0);

  /// Writes whole rows at the end.
  void append(std::span<const double> rows);

  hid_t id() const { return dataset_.get(); }

  /// Rows of a chunk.
  hsize_t chunk_rows() const { return chunk_rows_; }
  /// Numbers of a row.
  hsize_t row_size() const { return row_size_; }

private:
  const std::filesystem::path& file_;
  std::string name_;
  Handle dataset_;
  std::vector<hsize_t> shape_; ///< as declared in the file: at least one row
  hsize_t rows_ = 0;
  hsize_t chunk_rows_;
  hsize_t row_size_ = 1;
};

} // namespace tremolo::results
