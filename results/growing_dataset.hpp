#pragma once

// A dataset that grows by rows: [rows, ...]. Not compressed, so that a chunk keeps its place in the file when
// it fills up; rows that the file declares but whose values never arrived (an empty dataset has one) read as
// NaN.

#include "results/hdf5_write.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace tremolo::results {

class GrowingDataset {
public:
  /// Creates an empty dataset whose rows have the shape `row_shape` (empty: one number a row).
  GrowingDataset(Place place, std::string_view name, std::span<const hsize_t> row_shape);

  /// Writes whole rows at the end.
  void append(std::span<const double> rows);

  hid_t id() const { return dataset_.get(); }

private:
  const std::filesystem::path& file_;
  std::string name_;
  Handle dataset_;
  std::vector<hsize_t> shape_; ///< as declared in the file: at least one row
  hsize_t rows_ = 0;
  hsize_t row_size_ = 1;
};

} // namespace tremolo::results
