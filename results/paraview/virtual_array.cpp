#include "results/paraview/virtual_array.hpp"

#include <fmt/format.h>

#include <array>

namespace tremolo::results {
namespace {

/// A space of rows, and of columns unless there are 0.
Handle space_of(hsize_t rows, hsize_t columns) {
  const std::array<hsize_t, 2> shape{rows, columns};
  return {H5Screate_simple(columns == 0 ? 1 : 2, shape.data(), nullptr), H5Sclose};
}

void select(const Handle& space, hsize_t first, hsize_t rows, hsize_t columns) {
  const std::array<hsize_t, 2> start{first, 0};
  const std::array<hsize_t, 2> count{rows, columns};
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
}

} // namespace

VirtualArray::VirtualArray(hsize_t rows, hsize_t columns) : rows_(rows), columns_(columns) {}

void VirtualArray::append(const SourceRows& rows) {
  if (rows.count > 0)
    pieces_.push_back({next_, rows});
  next_ += rows.count;
}

void VirtualArray::write(Place place, const std::string& name, hid_t type, const void* fill) const {
  const std::string action = fmt::format("write {}", name);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  checked(H5Pset_fill_value(properties.get(), type, fill), place.file, action);
  const Handle space = space_of(rows_, columns_);
  for (const Piece& piece : pieces_) {
    const SourceRows& source = piece.source;
    const Handle from = space_of(source.all, source.columns);
    select(from, source.first, source.count, source.columns);
    select(space, piece.first, source.count, source.columns);
    checked(H5Pset_virtual(properties.get(), space.get(), ".", source.dataset.c_str(), from.get()),
            place.file, action);
  }
  const Handle whole = space_of(rows_, columns_);
  const Handle dataset(checked(H5Dcreate2(place.object, name.c_str(), type, whole.get(), H5P_DEFAULT,
                                          properties.get(), H5P_DEFAULT),
                               place.file, action),
                       H5Dclose);
}

} // namespace tremolo::results
