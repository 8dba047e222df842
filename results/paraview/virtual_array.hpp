#pragma once

#include "results/hdf5/hdf5_write.hpp"

#include <string>
#include <vector>

namespace tremolo::results {

/// Rows of a dataset of the same file.
struct SourceRows {
  std::string dataset; ///< its path
  hsize_t all = 0;     ///< rows that it has
  hsize_t columns = 0; ///< 0: it has one dimension
  hsize_t count = 0;   ///< rows that are taken
  hsize_t first = 0;   ///< of these
};

/// A dataset that holds no values: its rows are those of other datasets (a virtual dataset of HDF5 1.10).
/// Rows and columns that nothing is mapped to have its fill value.
class VirtualArray {
public:
  /// @param columns  0: one dimension
  VirtualArray(hsize_t rows, hsize_t columns);

  /// The next rows are these.
  void append(const SourceRows& rows);
  /// The next rows have the fill value.
  void skip(hsize_t rows) { next_ += rows; }

  /// @param type  of the values; `fill` is one of it
  void write(Place place, const std::string& name, hid_t type, const void* fill) const;

private:
  struct Piece {
    hsize_t first;
    SourceRows source;
  };
  hsize_t rows_;
  hsize_t columns_;
  hsize_t next_ = 0;
  std::vector<Piece> pieces_;
};

} // namespace tremolo::results
