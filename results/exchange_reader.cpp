#include "results/exchange_file.hpp"

#include "results/exchange_layout.hpp"
#include "results/run_status.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>

namespace tremolo::results {
namespace {

/// A column of a table that holds values of this type.
template <class Value>
const std::vector<Value>& column(const Table& table, std::string_view name) {
  const auto found = std::ranges::find(table.columns, name, &Table::Column::name);
  const auto* values =
      found == table.columns.end() ? nullptr : std::get_if<std::vector<Value>>(&found->values);
  if (values == nullptr) {
    throw std::runtime_error(fmt::format("the column {} is missing or has another type", name));
  }
  return *values;
}

std::vector<double> pairs(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> values;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    values.insert(values.end(), {first[i], second[i]});
  }
  return values;
}

std::vector<double> vectors(const Table& table, const std::string& first, const std::string& second) {
  return pairs(column<double>(table, first), column<double>(table, second));
}

ExchangeFaces faces_from(const Table& table) {
  return {.position = vectors(table, "x", "y"),
          .normal = vectors(table, "normal_x", "normal_y"),
          .impedance = vectors(table, "impedance_p", "impedance_s"),
          .static_traction = vectors(table, "static_traction_x", "static_traction_y"),
          .source = column<std::string>(table, "source"),
          .field = column<std::string>(table, "field")};
}

std::vector<RecordedValue> values_from(const Table& table) {
  const auto& keys = column<std::string>(table, "key");
  const auto& texts = column<std::string>(table, "value");
  std::vector<RecordedValue> values;
  for (std::size_t i = 0; i < std::min(keys.size(), texts.size()); ++i) {
    values.push_back({keys[i], texts[i]});
  }
  return values;
}

} // namespace

class ExchangeReader::Implementation {
public:
  explicit Implementation(const std::filesystem::path& path) : file(path, "recording") {
    if (!file.has_attribute("/", "content") ||
        file.attribute_as<std::string>("/", "content") != exchange_content) {
      throw std::runtime_error(
          fmt::format("{}: is no recording of an exchange: the attribute content = \"{}\" is missing",
                      path.string(), exchange_content));
    }
    file.require_schema(exchange_schema_version);
    try {
      read_description();
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      throw std::runtime_error(text.starts_with(path.string()) ? text
                                                               : fmt::format("{}: {}", path.string(), text));
    }
  }

  void read_description() {
    description.session = file.attribute_as<std::string>("/", "session");
    description.mode = file.attribute_as<std::string>("/", "mode");
    description.start_time = file.attribute_as<double>("/", "start_time");
    description.end_time = file.attribute_as<double>("/", "end_time");
    description.case_text = file.text("case");
    description.case_values = values_from(file.table("case_values"));
    for (const std::string& name : file.children("/sources")) {
      description.sources.push_back(read_source(name));
    }
    description.domain = file.attribute_as<std::string>("domain", "name");
    description.domain_number = file.attribute_as<std::int64_t>("domain", "number");
    description.faces = faces_from(file.table("domain/faces"));
    time = file.dataset("domain/time");
    velocity = file.dataset("domain/velocity");
    steps = std::min(rows(time, 1, "domain/time"), rows(velocity, 3, "domain/velocity"));
    if (file.exists("domain/traction")) {
      traction = file.dataset("domain/traction");
      traction_steps = rows(traction, 3, "domain/traction");
    }
  }

  ExchangeSource read_source(const std::string& name) const {
    const std::string group = "sources/" + name;
    ExchangeSource source{.name = name,
                          .number = file.attribute_as<std::int64_t>(group, "number"),
                          .serves = file.attribute_as<std::vector<std::string>>(group, "serves"),
                          .fields = FreeFieldRecording(file.path(), name).fields()};
    for (RecordedField& field : source.fields) {
      field.step_count = static_cast<std::uint64_t>(
          file.attribute_as<std::int64_t>(fmt::format("{}/{}", group, field.name), "declared_steps"));
    }
    return source;
  }

  /// Rows of a dataset [rows], or [rows, faces, 2].
  std::uint64_t rows(const Handle& dataset, std::size_t rank, std::string_view name) const {
    const Handle space(H5Dget_space(dataset.get()), H5Sclose);
    const auto shape = file.shape(space.get());
    if (shape.size() != rank || (rank == 3 && (shape[1] != description.faces.count() || shape[2] != 2))) {
      throw std::runtime_error(
          fmt::format("{} has the shape [{}], expected [steps{}]", name, fmt::join(shape, ", "),
                      rank == 3 ? fmt::format(", {}, 2", description.faces.count()) : ""));
    }
    return shape[0];
  }

  /// One row of such a dataset.
  void read_row(const Handle& dataset, std::uint64_t row, std::span<double> values) const {
    const Handle space(H5Dget_space(dataset.get()), H5Sclose);
    auto count = file.shape(space.get());
    std::vector<hsize_t> start(count.size(), 0);
    start[0] = row;
    count[0] = 1;
    const hsize_t size = values.size();
    const Handle memory(H5Screate_simple(1, &size, nullptr), H5Sclose);
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    checked(H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, memory.get(), space.get(), H5P_DEFAULT, values.data()),
            file.path(), fmt::format("read step {} of the domain", row));
  }

  void require_step(std::uint64_t step, std::uint64_t held) const {
    if (step >= held) {
      throw std::out_of_range(fmt::format("{}: step {} of the domain is not held, only {} steps are",
                                          file.path().string(), step, held));
    }
  }

  FileReader file;
  ExchangeDescription description;
  Handle time;
  Handle velocity;
  Handle traction;
  std::uint64_t steps = 0;
  std::uint64_t traction_steps = 0;
};

ExchangeReader::ExchangeReader(const std::filesystem::path& file)
    : implementation_(std::make_unique<Implementation>(file)) {}
ExchangeReader::~ExchangeReader() = default;

std::string ExchangeReader::status() const {
  return implementation_->file.attribute_as<std::string>("/", "status");
}

bool ExchangeReader::complete() const {
  return status() == status_complete;
}

const ExchangeDescription& ExchangeReader::description() const {
  return implementation_->description;
}

const ExchangeSource& ExchangeReader::source_of(std::string_view side) const {
  const auto& sources = description().sources;
  const auto found = std::ranges::find_if(sources, [&](const ExchangeSource& source) {
    return std::ranges::find(source.serves, side) != source.serves.end();
  });
  if (found == sources.end()) {
    throw std::runtime_error(fmt::format("{}: no source of this exchange served the side '{}'",
                                         implementation_->file.path().string(), side));
  }
  return *found;
}

std::vector<RecordedFrame> ExchangeReader::frames(const std::string& participant,
                                                  const std::string& field) const {
  const std::string path = participant == "domain" ? fmt::format("domain/{}_frames", field)
                                                   : fmt::format("sources/{}/{}/frames", participant, field);
  const FileReader& file = implementation_->file;
  const auto numbers = file.numbers<double>(file.dataset(path).get(), H5T_NATIVE_DOUBLE, path);
  std::vector<RecordedFrame> frames;
  for (std::size_t i = 0; i + frame_columns <= numbers.size(); i += frame_columns) {
    frames.push_back({static_cast<std::uint64_t>(numbers[i]), static_cast<std::uint64_t>(numbers[i + 1]),
                      static_cast<std::uint32_t>(numbers[i + 2])});
  }
  return frames;
}

std::uint64_t ExchangeReader::domain_steps() const {
  return implementation_->steps;
}

std::vector<double> ExchangeReader::velocities(std::uint64_t step) const {
  implementation_->require_step(step, implementation_->steps);
  std::vector<double> values(1 + 2 * description().faces.count());
  implementation_->read_row(implementation_->time, step, std::span(values).first(1));
  implementation_->read_row(implementation_->velocity, step, std::span(values).subspan(1));
  return values;
}

std::vector<double> ExchangeReader::tractions(std::uint64_t step) const {
  if (implementation_->traction_steps == 0) {
    return {};
  }
  implementation_->require_step(step, implementation_->traction_steps);
  std::vector<double> values(2 * description().faces.count());
  implementation_->read_row(implementation_->traction, step, values);
  return values;
}

} // namespace tremolo::results
