#include "results/free_field_recording.hpp"

#include "results/exchange_file.hpp"
#include "results/exchange_layout.hpp"
#include "results/hdf5/array_in_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace tremolo::results {
namespace {

void check(const FieldToRecord& record) {
  const auto& [field, values] = record;
  const std::size_t expected = field.step_count * field.levels.size() * recorded_values;
  if (expected == 0 || values.size() != expected) {
    throw std::invalid_argument(
        fmt::format("field '{}': {} values do not fill {} steps at {} levels of {} values each", field.name,
                    values.size(), field.step_count, field.levels.size(), recorded_values));
  }
}

void write_field(Place place, const FieldToRecord& record) {
  const auto& [field, values] = record;
  const Handle group = create_group(place, field.name, field_quantities.size() + 1);
  const Place inside{group.get(), place.file};
  for (const auto& [name, value] : {std::pair<std::string_view, double>{"x_reference", field.x_reference},
                                    {"slowness_x", field.slowness_x},
                                    {"start_time", field.start_time},
                                    {"time_step", field.time_step}}) {
    write_attribute(inside, name, value);
  }
  const hsize_t level_count = field.levels.size();
  write_array(inside, "levels", {&level_count, 1}, std::span<const double>(field.levels), "m", false);
  const std::size_t rows = values.size() / recorded_values;
  for (const Quantity& quantity : field_quantities) {
    std::vector<double> column;
    column.reserve(rows * quantity.components);
    for (std::size_t row = 0; row < rows; ++row) {
      const auto part = values.subspan(row * recorded_values + quantity.first, quantity.components);
      column.insert(column.end(), part.begin(), part.end());
    }
    const std::array<hsize_t, 3> shape{field.step_count, level_count, quantity.components};
    write_array(inside, quantity.name, shape, std::span<const double>(column), quantity.unit, false);
  }
}

} // namespace

void write_free_field_recording(const std::filesystem::path& file, const std::string& title,
                                const std::string& profile, std::span<const FieldToRecord> fields) {
  for (const auto& field : fields) {
    check(field);
  }
  const Handle open_file = create_file(file);
  const Place root{open_file.get(), file};
  write_attribute(root, "schema_version", std::string(recording_schema_version));
  write_attribute(root, "content", std::string("free field"));
  write_attribute(root, "title", title);
  write_attribute(root, "profile", profile);
  std::vector<std::string> names;
  for (const auto& field : fields) {
    write_field(root, field);
    names.push_back(field.field.name);
  }
  write_attribute(root, "fields", names);
  flush_file(open_file, file);
}

class FreeFieldRecording::Implementation {
public:
  explicit Implementation(const std::filesystem::path& file) : source(file, "recording") {
    require_content("free field");
    source.require_schema(recording_schema_version);
    for (const auto& name : source.attribute_as<std::vector<std::string>>("/", "fields")) {
      open(name, name);
      require_whole(fields.back().name);
    }
  }

  Implementation(const std::filesystem::path& file, const std::string& participant)
      : source(file, "recording") {
    require_content(exchange_content);
    source.require_schema(exchange_schema_version);
    const std::string group = "sources/" + participant;
    for (const auto& name : source.attribute_as<std::vector<std::string>>(group, "fields")) {
      open(name, group + "/" + name);
    }
  }

  void require_content(std::string_view content) const {
    const bool known = source.has_attribute("/", "content");
    if (known && source.attribute_as<std::string>("/", "content") == content) {
      return;
    }
    throw std::runtime_error(fmt::format(
        "{}: is no recording of {}: the attribute content is {}, not \"{}\"", source.path().string(),
        content == exchange_content ? "an exchange" : "a free field",
        known ? fmt::format("\"{}\"", source.attribute_as<std::string>("/", "content")) : "missing",
        content));
  }

  void open(const std::string& name, const std::string& group) {
    const std::string levels = group + "/levels";
    fields.push_back(
        {.name = name,
         .levels = source.numbers<double>(source.dataset(levels).get(), H5T_NATIVE_DOUBLE, levels),
         .x_reference = source.attribute_as<double>(group, "x_reference"),
         .slowness_x = source.attribute_as<double>(group, "slowness_x"),
         .start_time = source.attribute_as<double>(group, "start_time"),
         .time_step = source.attribute_as<double>(group, "time_step"),
         .step_count = std::numeric_limits<std::uint64_t>::max()});
    RecordedField& field = fields.back();
    auto& opened = datasets.emplace_back();
    auto& held = steps.emplace_back();
    for (std::size_t q = 0; q < field_quantities.size(); ++q) {
      const std::string path = fmt::format("{}/{}", group, field_quantities[q].name);
      opened[q] = source.dataset(path);
      const Handle space(H5Dget_space(opened[q].get()), H5Sclose);
      const auto shape = source.shape(space.get());
      held[q] = shape.empty() ? 0 : shape[0];
      if (const std::vector<hsize_t> expected{held[q], field.levels.size(), field_quantities[q].components};
          shape != expected) {
        throw std::runtime_error(fmt::format("{}: {} has the shape [{}], expected [{}]",
                                             source.path().string(), path, fmt::join(shape, ", "),
                                             fmt::join(expected, ", ")));
      }
      field.step_count = std::min<std::uint64_t>(field.step_count, held[q]);
    }
  }

  /// The quantities of a recording that was cut short may end at different steps; those of a whole one not.
  void require_whole(const std::string& name) const {
    for (std::size_t q = 0; q < field_quantities.size(); ++q) {
      if (steps.back()[q] != steps.back()[0]) {
        throw std::runtime_error(fmt::format("{}: {}/{} has {} steps, {}/{} has {}", source.path().string(),
                                             name, field_quantities[0].name, steps.back()[0], name,
                                             field_quantities[q].name, steps.back()[q]));
      }
    }
  }

  FileReader source;
  std::vector<RecordedField> fields;
  std::vector<std::array<Handle, field_quantities.size()>> datasets;
  std::vector<std::array<hsize_t, field_quantities.size()>> steps;
};

FreeFieldRecording::FreeFieldRecording(const std::filesystem::path& file)
    : implementation_(std::make_unique<Implementation>(file)) {}
FreeFieldRecording::FreeFieldRecording(const std::filesystem::path& exchange, const std::string& source)
    : implementation_(std::make_unique<Implementation>(exchange, source)) {}
FreeFieldRecording::~FreeFieldRecording() = default;

const std::vector<RecordedField>& FreeFieldRecording::fields() const {
  return implementation_->fields;
}

void FreeFieldRecording::read(std::size_t field, std::uint64_t step, std::span<double> values) const {
  const std::size_t levels = fields().at(field).levels.size();
  if (step >= fields()[field].step_count || values.size() != levels * recorded_values) {
    throw std::out_of_range(fmt::format("step {} of field '{}' into {} values: there are {} steps of {}",
                                        step, fields()[field].name, values.size(), fields()[field].step_count,
                                        levels * recorded_values));
  }
  // In memory the quantities of a level are adjacent: a selection of columns of [levels, recorded_values].
  const std::array<hsize_t, 2> memory_shape{levels, recorded_values};
  const Handle memory(H5Screate_simple(2, memory_shape.data(), nullptr), H5Sclose);
  for (std::size_t q = 0; q < field_quantities.size(); ++q) {
    const hid_t dataset = implementation_->datasets[field][q].get();
    const std::array<hsize_t, 2> memory_start{0, field_quantities[q].first};
    const std::array<hsize_t, 2> memory_count{levels, field_quantities[q].components};
    const std::array<hsize_t, 3> start{step, 0, 0};
    const std::array<hsize_t, 3> count{1, levels, field_quantities[q].components};
    const Handle space(H5Dget_space(dataset), H5Sclose);
    H5Sselect_hyperslab(memory.get(), H5S_SELECT_SET, memory_start.data(), nullptr, memory_count.data(),
                        nullptr);
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    checked(H5Dread(dataset, H5T_NATIVE_DOUBLE, memory.get(), space.get(), H5P_DEFAULT, values.data()),
            implementation_->source.path(), fmt::format("read step {}", step));
  }
}

} // namespace tremolo::results
