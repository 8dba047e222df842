#include "results/hdf5_handle.hpp"
#include "results/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::results {
namespace {

/// Reads attributes and datasets of one file.
class Source {
public:
  explicit Source(const std::filesystem::path& path) : path_(path) {
    silence_hdf5();
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(access.get(), false, true);
    file_ = Handle(checked(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access.get()), path_, "open the run file"),
                   H5Fclose);
  }

  hid_t root() const { return file_.get(); }
  const std::filesystem::path& path() const { return path_; }

  bool exists(const std::string& name) const { return H5Lexists(root(), name.c_str(), H5P_DEFAULT) > 0; }

  std::vector<std::string> children(const std::string& group_path) const {
    const Handle group(
        checked(H5Gopen2(root(), group_path.c_str(), H5P_DEFAULT), path_, "open " + group_path), H5Gclose);
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

  Handle dataset(const std::string& name) const {
    return {checked(H5Dopen2(root(), name.c_str(), H5P_DEFAULT), path_, "open " + name), H5Dclose};
  }

  std::vector<hsize_t> shape(hid_t space) const {
    std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    return extents;
  }

  /// The numbers of a dataset as `Number`.
  template <class Number>
  std::vector<Number> numbers(hid_t id, hid_t memory_type, const std::string& name) const {
    const Handle space(H5Dget_space(id), H5Sclose);
    std::vector<Number> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
    checked(H5Dread(id, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path_, "read " + name);
    return values;
  }

  std::string text(const std::string& name) const {
    const Handle data = dataset(name);
    const Handle type(H5Dget_type(data.get()), H5Tclose);
    std::string bytes(H5Tget_size(type.get()), '\0');
    checked(H5Dread(data.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), path_,
            "read " + name);
    return trimmed(bytes);
  }

  std::vector<std::string> strings(hid_t id, hid_t type, const std::string& name) const {
    const Handle space(H5Dget_space(id), H5Sclose);
    const std::size_t count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
    std::string bytes(count * H5Tget_size(type), '\0');
    checked(H5Dread(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), path_, "read " + name);
    return split(bytes, count);
  }

  bool has_attribute(const std::string& object, const std::string& name) const {
    return H5Aexists_by_name(root(), object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
  }

  AttributeValue attribute(const std::string& object, const std::string& name) const {
    const std::string action = fmt::format("read attribute {} of {}", name, object);
    const Handle attribute(
        checked(H5Aopen_by_name(root(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), path_,
                action),
        H5Aclose);
    const Handle type(H5Aget_type(attribute.get()), H5Tclose);
    const Handle space(H5Aget_space(attribute.get()), H5Sclose);
    const bool scalar = H5Sget_simple_extent_type(space.get()) == H5S_SCALAR;
    const std::size_t count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
    switch (H5Tget_class(type.get())) {
    case H5T_STRING: {
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
  static std::string trimmed(const std::string& bytes) { return bytes.substr(0, bytes.find('\0')); }

  static std::vector<std::string> split(const std::string& bytes, std::size_t count) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t length = bytes.size() / count;
      out.push_back(trimmed(bytes.substr(i * length, length)));
    }
    return out;
  }

  std::filesystem::path path_;
  Handle file_;
};

} // namespace

class RunReader::Implementation {
public:
  explicit Implementation(const std::filesystem::path& path) : source(path) {
    const auto version = source.attribute_as<std::string>("/", "schema_version");
    const auto major = [](std::string_view text) { return text.substr(0, text.find('.')); };
    if (major(version) != major(schema_version)) {
      throw std::runtime_error(
          fmt::format("{}: schema version {} cannot be read by this build, which knows {}", path.string(),
                      version, schema_version));
    }
    frame_names = source.children("/frames");
    std::ranges::sort(frame_names, {}, [](const std::string& name) { return std::stoul(name); });
    for (const auto& name : frame_names) {
      frame_times.push_back(source.attribute_as<double>("/frames/" + name, "time"));
    }
  }

  std::string frame_path(std::size_t frame) const {
    if (frame >= frame_names.size()) {
      throw std::runtime_error(fmt::format("{}: no frame {}, the run holds {}", source.path().string(), frame,
                                           frame_names.size()));
    }
    return "/frames/" + frame_names[frame];
  }

  Source source;
  std::vector<std::string> frame_names;
  std::vector<double> frame_times;
};

RunReader::RunReader(const std::filesystem::path& file)
    : implementation_(std::make_unique<Implementation>(file)) {}
RunReader::~RunReader() = default;

std::string RunReader::title() const {
  return implementation_->source.attribute_as<std::string>("/", "title");
}
std::string RunReader::status() const {
  return implementation_->source.attribute_as<std::string>("/", "status");
}
std::string RunReader::case_text() const {
  return implementation_->source.text("/case");
}
std::string RunReader::plan() const {
  return implementation_->source.text("/plan");
}

bool RunReader::has_attribute(std::string_view name) const {
  return implementation_->source.has_attribute("/", std::string(name));
}
AttributeValue RunReader::attribute(std::string_view name) const {
  return implementation_->source.attribute("/", std::string(name));
}

const std::vector<double>& RunReader::frame_times() const {
  return implementation_->frame_times;
}

std::vector<std::string> RunReader::frame_fields(std::size_t frame) const {
  return implementation_->source.children(implementation_->frame_path(frame));
}

FieldData RunReader::frame_field(std::size_t frame, std::string_view name) const {
  const Source& source = implementation_->source;
  const std::string path = fmt::format("{}/{}", implementation_->frame_path(frame), name);
  const Handle data = source.dataset(path);
  const Handle space(H5Dget_space(data.get()), H5Sclose);
  const auto shape = source.shape(space.get());
  return {source.attribute_as<std::string>(path, "unit"),
          shape.size() > 1 ? static_cast<std::size_t>(shape[1]) : 1,
          source.numbers<double>(data.get(), H5T_NATIVE_DOUBLE, path)};
}

std::vector<std::string> RunReader::monitors() const {
  return implementation_->source.children("/monitors");
}

SeriesData RunReader::series(std::string_view path) const {
  const Source& source = implementation_->source;
  const std::string name(path);
  SeriesData series{source.attribute_as<std::vector<std::string>>(name, "columns"),
                    source.attribute_as<std::vector<std::string>>(name, "units"),
                    source.numbers<double>(source.dataset(name).get(), H5T_NATIVE_DOUBLE, name)};
  const std::size_t width = series.columns.size();
  // A writer that died while it flushed may have declared rows whose values never arrived.
  while (series.rows() > 0 && std::isnan(series.values[(series.rows() - 1) * width])) {
    series.values.resize(series.values.size() - width);
  }
  return series;
}

bool RunReader::has_table(std::string_view path) const {
  return implementation_->source.exists(std::string(path));
}

Table RunReader::table(std::string_view path) const {
  const Source& source = implementation_->source;
  Table table;
  for (const auto& name : source.attribute_as<std::vector<std::string>>(std::string(path), "columns")) {
    const std::string column = fmt::format("{}/{}", path, name);
    const Handle data = source.dataset(column);
    const Handle type(H5Dget_type(data.get()), H5Tclose);
    Table::Column out{name, {}, {}};
    if (source.has_attribute(column, "unit")) {
      out.unit = source.attribute_as<std::string>(column, "unit");
    }
    switch (H5Tget_class(type.get())) {
    case H5T_STRING:
      out.values = source.strings(data.get(), type.get(), column);
      break;
    case H5T_INTEGER:
      out.values = source.numbers<std::int64_t>(data.get(), H5T_NATIVE_INT64, column);
      break;
    default:
      out.values = source.numbers<double>(data.get(), H5T_NATIVE_DOUBLE, column);
    }
    table.columns.push_back(std::move(out));
  }
  return table;
}

} // namespace tremolo::results
