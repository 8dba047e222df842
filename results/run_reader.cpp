#include "results/hdf5/hdf5_read.hpp"
#include "results/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::results {

std::vector<double> SeriesData::column(std::string_view name) const {
  const auto found = std::ranges::find(columns, name);
  if (found == columns.end())
    throw std::runtime_error(fmt::format("a series of the run has no column '{}'", name));
  std::vector<double> numbers;
  for (auto i = static_cast<std::size_t>(found - columns.begin()); i < values.size(); i += columns.size())
    numbers.push_back(values[i]);
  return numbers;
}

class RunReader::Implementation {
public:
  explicit Implementation(const std::filesystem::path& path) : source(path, "run file") {
    source.require_schema(schema_version);
    frame_names = source.children("/frames");
    std::ranges::sort(frame_names, {}, [](const std::string& name) { return std::stoul(name); });
    for (const auto& name : frame_names) {
      frame_times.push_back(source.attribute_as<double>("/frames/" + name, "time"));
    }
  }

  /// @param group  "frames", or one of frame_parts
  std::string frame_path(std::size_t frame, std::string_view group = "frames") const {
    if (frame >= frame_names.size()) {
      throw std::runtime_error(fmt::format("{}: no frame {}, the run holds {}", source.path().string(), frame,
                                           frame_names.size()));
    }
    return fmt::format("/{}/{}", group, frame_names[frame]);
  }

  FieldShape shape(const std::string& path) const {
    const Handle data = source.dataset(path);
    const Handle space(H5Dget_space(data.get()), H5Sclose);
    const Handle type(H5Dget_type(data.get()), H5Tclose);
    const auto extent = source.shape(space.get());
    return {source.attribute_as<std::string>(path, "unit"),
            extent.empty() ? 0 : static_cast<std::size_t>(extent[0]),
            extent.size() > 1 ? static_cast<std::size_t>(extent[1]) : 1,
            H5Tget_class(type.get()) == H5T_INTEGER};
  }

  FieldData field(const std::string& path) const {
    const auto [unit, particles, components, integers] = shape(path);
    const Handle data = source.dataset(path);
    return {unit, components, source.numbers<double>(data.get(), H5T_NATIVE_DOUBLE, path), integers};
  }

  template <class Number>
  void field_in_pieces(const std::string& path, hid_t type, std::size_t particles,
                       const std::function<void(FieldValues piece)>& take) const {
    constexpr std::size_t at_once = std::size_t{1} << 16; // particles of a chunk
    const Handle data = source.dataset(path);
    for (std::size_t first = 0; first < particles; first += at_once) {
      const auto values = source.rows<Number>(data, type, first, std::min(at_once, particles - first), path);
      take(std::span<const Number>(values));
    }
  }

  FileReader source;
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
  return implementation_->field(fmt::format("{}/{}", implementation_->frame_path(frame), name));
}

FieldShape RunReader::frame_field_shape(std::size_t frame, std::string_view name) const {
  return implementation_->shape(fmt::format("{}/{}", implementation_->frame_path(frame), name));
}

void RunReader::frame_field_in_pieces(std::size_t frame, std::string_view name,
                                      const std::function<void(FieldValues piece)>& take) const {
  const std::string path = fmt::format("{}/{}", implementation_->frame_path(frame), name);
  const FieldShape shape = implementation_->shape(path);
  if (shape.integers)
    implementation_->field_in_pieces<std::int32_t>(path, H5T_NATIVE_INT32, shape.particles, take);
  else
    implementation_->field_in_pieces<double>(path, H5T_NATIVE_DOUBLE, shape.particles, take);
}

std::vector<std::string> RunReader::part_fields(std::string_view group, std::size_t frame) const {
  if (!implementation_->source.exists(std::string(group))) {
    return {};
  }
  return implementation_->source.children(implementation_->frame_path(frame, group));
}

FieldData RunReader::part_field(std::string_view group, std::size_t frame, std::string_view name) const {
  return implementation_->field(fmt::format("{}/{}", implementation_->frame_path(frame, group), name));
}

BoundaryHistory RunReader::boundary() const {
  const FileReader& source = implementation_->source;
  const auto read = [&](const std::string& name) {
    const std::string path = "/boundary/" + name;
    return source.numbers<double>(source.dataset(path).get(), H5T_NATIVE_DOUBLE, path);
  };
  return {read("time"), read("free_field_velocity"), read("domain_velocity"), read("traction")};
}

std::vector<std::string> RunReader::monitors() const {
  return implementation_->source.children("/monitors");
}

SeriesData RunReader::series(std::string_view path) const {
  const FileReader& source = implementation_->source;
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
  return implementation_->source.table(std::string(path));
}

} // namespace tremolo::results
