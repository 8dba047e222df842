#include "results/hdf5/array_in_pieces.hpp"

#include "base/dataset_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace tremolo::results {
namespace {

/// Rows of a compressed chunk: large enough to compress well, small enough to be read in part.
constexpr hsize_t chunk_rows = 65536;

Handle properties_of(std::span<const hsize_t> shape, ArrayLayout layout) {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (layout.chunk_rows > 0) {
    std::vector<hsize_t> chunk(shape.begin(), shape.end());
    chunk[0] = std::min(chunk[0], layout.chunk_rows);
    H5Pset_chunk(properties.get(), static_cast<int>(shape.size()), chunk.data());
    if (layout.compressed) {
      H5Pset_shuffle(properties.get());
      H5Pset_deflate(properties.get(), 1);
    }
    H5Pset_fletcher32(properties.get());
  }
  return properties;
}

} // namespace

ArrayLayout compressed_layout(std::size_t bytes) {
  return bytes >= fewest_chunk_bytes ? ArrayLayout{chunk_rows, true} : ArrayLayout{};
}

ArrayInPieces::ArrayInPieces(Place place, std::string_view name, hid_t type, std::span<const hsize_t> shape,
                             ArrayLayout layout)
    : file_(place.file), name_(name), type_(type), shape_(shape.begin(), shape.end()),
      row_size_(std::accumulate(shape.begin() + 1, shape.end(), std::size_t{1}, std::multiplies<>())),
      value_bytes_(H5Tget_size(type)), rows_at_once_(layout.chunk_rows > 0 ? layout.chunk_rows : shape[0]) {
  const Handle space(H5Screate_simple(static_cast<int>(shape_.size()), shape_.data(), nullptr), H5Sclose);
  const Handle properties = properties_of(shape, layout);
  dataset_ = Handle(checked(H5Dcreate2(place.object, name_.c_str(), type_, space.get(), H5P_DEFAULT,
                                       properties.get(), H5P_DEFAULT),
                            file_, fmt::format("write {}", name_)),
                    H5Dclose);
}

void ArrayInPieces::add(FieldValues values) {
  std::visit([&](auto span) { add(span.data(), span.size()); }, values);
}

void ArrayInPieces::add(const void* values, std::size_t count) {
  const std::size_t all = shape_[0] * row_size_;
  if (count > all - taken_ || count % row_size_ != 0) {
    throw std::invalid_argument(fmt::format("{} has {} values in rows of {}, and after {} of them came {}",
                                            name_, all, row_size_, taken_, count));
  }
  taken_ += count;
  const std::size_t row_bytes = row_size_ * value_bytes_;
  const auto* next = static_cast<const std::byte*>(values);
  std::size_t rows = count / row_size_;
  if (!pending_.empty()) {
    const std::size_t some = std::min(rows, rows_at_once_ - pending_.size() / row_bytes);
    pending_.insert(pending_.end(), next, next + some * row_bytes);
    next += some * row_bytes;
    rows -= some;
    if (pending_.size() < rows_at_once_ * row_bytes && taken_ < all) {
      return;
    }
    write_rows(pending_.data(), pending_.size() / row_bytes);
    pending_.clear();
  }
  const std::size_t whole = taken_ == all ? rows : rows - rows % rows_at_once_;
  write_rows(next, whole);
  pending_.assign(next + whole * row_bytes, next + rows * row_bytes);
}

void ArrayInPieces::write_rows(const std::byte* values, hsize_t rows) {
  if (rows == 0) {
    return;
  }
  std::vector<hsize_t> start(shape_.size(), 0);
  start[0] = written_;
  std::vector<hsize_t> count = shape_;
  count[0] = rows;
  written_ += rows;
  const Handle space(H5Dget_space(dataset_.get()), H5Sclose);
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  const Handle memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
  checked(H5Dwrite(dataset_.get(), type_, memory.get(), space.get(), H5P_DEFAULT, values), file_,
          fmt::format("write {}", name_));
}

void ArrayInPieces::finish(std::string_view unit) {
  if (const std::size_t all = shape_[0] * row_size_; taken_ < all) {
    throw std::invalid_argument(fmt::format("{} has {} values where it needs {}", name_, taken_, all));
  }
  if (!unit.empty()) {
    write_attribute({dataset_.get(), file_}, "unit", std::string(unit));
  }
  checked(H5Dclose(dataset_.release()), file_, fmt::format("write {}", name_)); // writes its metadata
}

void write_array(Place place, std::string_view name, std::span<const hsize_t> shape, FieldValues values,
                 std::string_view unit, bool compress) {
  const bool real = std::holds_alternative<std::span<const double>>(values);
  const std::size_t bytes = std::visit([](auto span) { return span.size_bytes(); }, values);
  ArrayInPieces array(place, name, real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT32, shape,
                      compress ? compressed_layout(bytes) : ArrayLayout{});
  array.add(values);
  array.finish(unit);
}

} // namespace tremolo::results
