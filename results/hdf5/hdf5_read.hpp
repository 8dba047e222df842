#pragma once

// Reading of attributes, arrays and strings of one file, with errors that name the file and the object.

#include "results/hdf5/hdf5_handle.hpp"
#include "results/run_data.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::results {

class FileReader {
public:
  /// @param what the file is, for messages: "run file"
  /// @throws std::runtime_error if the file cannot be opened, as all members do for what cannot be read
  FileReader(std::filesystem::path path, std::string_view what);

  hid_t root() const { return file_.get(); }
  const std::filesystem::path& path() const { return path_; }

  /// Refuses a file whose attribute schema_version has another major number than the known version.
  void require_schema(std::string_view known) const;

  bool exists(const std::string& name) const;
  std::vector<std::string> children(const std::string& group_path) const;

  Handle dataset(const std::string& name) const;
  std::vector<hsize_t> shape(hid_t space) const;

  /// The numbers of a dataset as `Number`.
  template <class Number>
  std::vector<Number> numbers(hid_t id, hid_t memory_type, const std::string& name) const {
    const Handle space(H5Dget_space(id), H5Sclose);
    std::vector<Number> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
    checked(H5Dread(id, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path_, "read " + name);
    return values;
  }
  /// Some rows of a dataset, as `Number`.
  template <class Number>
  std::vector<Number> rows(const Handle& dataset, hid_t memory_type, hsize_t first, hsize_t count,
                           const std::string& name) const {
    const Handle space(H5Dget_space(dataset.get()), H5Sclose);
    std::vector<hsize_t> extent = shape(space.get());
    std::vector<hsize_t> start(extent.size(), 0);
    start[0] = first;
    extent[0] = count;
    hsize_t size = 1;
    for (const hsize_t side : extent) {
      size *= side;
    }
    std::vector<Number> values(size);
    if (count == 0) {
      return values;
    }
    const Handle memory(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const std::string action = fmt::format("read {} rows from {} on of {}", count, first, name);
    checked(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr),
            path_, action);
    checked(H5Dread(dataset.get(), memory_type, memory.get(), space.get(), H5P_DEFAULT, values.data()), path_,
            action);
    return values;
  }
  std::string text(const std::string& name) const;
  std::vector<std::string> strings(hid_t id, hid_t type, const std::string& name) const;
  Table table(const std::string& name) const;

  bool has_attribute(const std::string& object, const std::string& name) const;
  AttributeValue attribute(const std::string& object, const std::string& name) const;

  /// An attribute of a known type.
  template <class Value>
  Value attribute_as(const std::string& object, const std::string& name) const {
    const AttributeValue value = attribute(object, name);
    if (const auto* typed = std::get_if<Value>(&value)) {
      return *typed;
    }
    throw std::runtime_error(
        fmt::format("{}: attribute {} of {} has an unexpected type", path_.string(), name, object));
  }

private:
  std::filesystem::path path_;
  Handle file_;
};

} // namespace tremolo::results
