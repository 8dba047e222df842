#include "results/hdf5/growing_dataset.hpp"

#include "base/dataset_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace tremolo::results {
namespace {

/// The fastest level of zlib: higher ones make a few per cent less of floating-point numbers.
constexpr unsigned deflate_level = 1;

void pack(hid_t properties) {
  H5Pset_shuffle(properties);
  H5Pset_deflate(properties, deflate_level);
  H5Pset_fletcher32(properties);
}

} // namespace

GrowingDataset::GrowingDataset(Place place, std::string_view name, std::span<const hsize_t> row_shape,
                               Storage storage, hsize_t chunk_rows)
    : file_(place.file), name_(name), shape_{0}, chunk_rows_(chunk_rows) {
  for (const hsize_t extent : row_shape) {
    shape_.push_back(extent);
    row_size_ *= extent;
  }
  const int rank = static_cast<int>(shape_.size());
  const bool packed = storage == Storage::packed;
  shape_[0] = packed ? 0 : 1; // allocated now, the row makes the index exist before the first flush
  std::vector<hsize_t> most = shape_;
  most[0] = H5S_UNLIMITED;
  if (chunk_rows_ == 0) {
    chunk_rows_ = rows_of_chunk(row_size_);
  }
  std::vector<hsize_t> chunk = shape_;
  chunk[0] = chunk_rows_;
  const double missing = std::numeric_limits<double>::quiet_NaN();

  const Handle space(H5Screate_simple(rank, shape_.data(), most.data()), H5Sclose);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(properties.get(), rank, chunk.data());
  if (packed) {
    pack(properties.get());
  } else {
    H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY);
  }
  H5Pset_fill_value(properties.get(), H5T_NATIVE_DOUBLE, &missing);
  dataset_ = Handle(checked(H5Dcreate2(place.object, name_.c_str(), H5T_NATIVE_DOUBLE, space.get(),
                                       H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                            file_, fmt::format("create {}", name_)),
                    H5Dclose);
}

void GrowingDataset::append(std::span<const double> rows) {
  if (rows.empty()) {
    return;
  }
  const std::string action = fmt::format("append to {}", name_);
  std::vector<hsize_t> start(shape_.size(), 0);
  start[0] = rows_;
  std::vector<hsize_t> count = shape_;
  count[0] = rows.size() / row_size_;
  rows_ += count[0];
  shape_[0] = rows_;
  checked(H5Dset_extent(dataset_.get(), shape_.data()), file_, action);
  const Handle space(H5Dget_space(dataset_.get()), H5Sclose);
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  const Handle memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
  checked(H5Dwrite(dataset_.get(), H5T_NATIVE_DOUBLE, memory.get(), space.get(), H5P_DEFAULT, rows.data()),
          file_, action);
}

} // namespace tremolo::results
