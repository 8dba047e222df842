#include "results/hdf5/hdf5_read.hpp"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace tremolo::results {
namespace {

std::string trimmed(const std::string& bytes) {
  return bytes.substr(0, bytes.find('\0'));
}

std::vector<std::string> split(const std::string& bytes, std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t length = bytes.size() / count;
    out.push_back(trimmed(bytes.substr(i * length, length)));
  }
  return out;
}

/// Texts of any length, as h5py writes them: the file holds references, which H5Aread() follows.
std::vector<std::string> of_any_length(hid_t attribute, hid_t type, hid_t space, std::size_t count,
                                       const std::filesystem::path& file, const std::string& action) {
  std::vector<char*> texts(count, nullptr);
  checked(H5Aread(attribute, type, texts.data()), file, action);
  std::vector<std::string> out;
  for (const char* text : texts)
    out.emplace_back(text == nullptr ? "" : text);
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, texts.data());
  return out;
}

std::string_view major(std::string_view version) {
  return version.substr(0, version.find('.'));
}

} // namespace

FileReader::FileReader(std::filesystem::path path, std::string_view what) : path_(std::move(path)) {
  std::error_code trouble;
  if (std::filesystem::exists(path_, trouble) && !std::filesystem::is_regular_file(path_, trouble))
    throw std::runtime_error( // opening a pipe would wait for its other end
        fmt::format("{}: cannot open the {}: not a regular file", path_.string(), what));
  prepare_hdf5();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access.get(), false, true);
  H5Pset_evict_on_close(access.get(), true); // as a writer in this process has it
  file_ = Handle(
      checked(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access.get()), path_, fmt::format("open the {}", what)),
      H5Fclose);
}

void FileReader::require_schema(std::string_view known) const {
  const auto version = attribute_as<std::string>("/", "schema_version");
  if (major(version) != major(known)) {
    throw std::runtime_error(fmt::format("{}: schema version {} cannot be read by this build, which knows {}",
                                         path_.string(), version, known));
  }
}

bool FileReader::exists(const std::string& name) const {
  return H5Lexists(root(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> FileReader::children(const std::string& group_path) const {
  const Handle group(checked(H5Gopen2(root(), group_path.c_str(), H5P_DEFAULT), path_, "open " + group_path),
                     H5Gclose);
  // Looking for a name that is not there decodes all links. H5Literate of libhdf5 1.10 does too, but where
  // one is damaged it frees links that it has not read yet.
  if (H5Lexists(group.get(), "no link has this name", H5P_DEFAULT) < 0)
    throw_hdf5_error(path_, "list " + group_path);
  std::vector<std::string> names;
  const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  hsize_t index = 0;
  checked(H5Literate(group.get(), H5_INDEX_NAME, H5_ITER_INC, &index, keep, &names), path_,
          "list " + group_path);
  return names;
}

Handle FileReader::dataset(const std::string& name) const {
  return {checked(H5Dopen2(root(), name.c_str(), H5P_DEFAULT), path_, "open " + name), H5Dclose};
}

std::vector<hsize_t> FileReader::shape(hid_t space) const {
  std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return extents;
}

std::string FileReader::text(const std::string& name) const {
  const Handle data = dataset(name);
  const Handle type(H5Dget_type(data.get()), H5Tclose);
  std::string bytes(H5Tget_size(type.get()), '\0');
  checked(H5Dread(data.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), path_,
          "read " + name);
  return trimmed(bytes);
}

std::vector<std::string> FileReader::strings(hid_t id, hid_t type, const std::string& name) const {
  const Handle space(H5Dget_space(id), H5Sclose);
  const std::size_t count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
  std::string bytes(count * H5Tget_size(type), '\0');
  checked(H5Dread(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), path_, "read " + name);
  return split(bytes, count);
}

bool FileReader::has_attribute(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(root(), object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

AttributeValue FileReader::attribute(const std::string& object, const std::string& name) const {
  const std::string action = fmt::format("read attribute {} of {}", name, object);
  const Handle attribute(
      checked(H5Aopen_by_name(root(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), path_, action),
      H5Aclose);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  const Handle space(H5Aget_space(attribute.get()), H5Sclose);
  const bool scalar = H5Sget_simple_extent_type(space.get()) == H5S_SCALAR;
  const std::size_t count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
  switch (H5Tget_class(type.get())) {
  case H5T_STRING: {
    if (H5Tis_variable_str(type.get()) > 0) {
      auto texts = of_any_length(attribute.get(), type.get(), space.get(), count, path_, action);
      return scalar ? AttributeValue(std::move(texts.front())) : AttributeValue(std::move(texts));
    }
    std::string bytes(count * H5Tget_size(type.get()), '\0');
    checked(H5Aread(attribute.get(), type.get(), bytes.data()), path_, action);
    return scalar ? AttributeValue(trimmed(bytes)) : AttributeValue(split(bytes, count));
  }
  case H5T_INTEGER: {
    std::int64_t value = 0;
    checked(H5Aread(attribute.get(), H5T_NATIVE_INT64, &value), path_, action);
    return value;
  }
  default: {
    std::vector<double> values(count);
    checked(H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, values.data()), path_, action);
    return scalar ? AttributeValue(values.front()) : AttributeValue(values);
  }
  }
}

Table FileReader::table(const std::string& name) const {
  Table table;
  for (const auto& column_name : attribute_as<std::vector<std::string>>(name, "columns")) {
    const std::string column = fmt::format("{}/{}", name, column_name);
    const Handle data = dataset(column);
    const Handle type(H5Dget_type(data.get()), H5Tclose);
    Table::Column out{column_name, {}, {}};
    if (has_attribute(column, "unit")) {
      out.unit = attribute_as<std::string>(column, "unit");
    }
    switch (H5Tget_class(type.get())) {
    case H5T_STRING:
      out.values = strings(data.get(), type.get(), column);
      break;
    case H5T_INTEGER:
      out.values = numbers<std::int64_t>(data.get(), H5T_NATIVE_INT64, column);
      break;
    default:
      out.values = numbers<double>(data.get(), H5T_NATIVE_DOUBLE, column);
    }
    table.columns.push_back(std::move(out));
  }
  return table;
}

} // namespace tremolo::results
