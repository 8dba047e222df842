#include "results/run_checksums.hpp"

#include "base/crc32.hpp"
#include "results/run_file.hpp"
#include "results/stored_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace tremolo::results {
namespace {

constexpr std::string_view frames = "/frames/";
constexpr std::string_view boundary = "/boundary/";

template <class Number>
std::uint32_t extended(std::uint32_t crc, std::span<const Number> values) {
  return crc32(crc, std::as_bytes(values));
}

/// A text, and where it ends.
std::uint32_t extended(std::uint32_t crc, std::string_view text) {
  const std::size_t size = text.size();
  return extended(extended(crc, std::span(text)), std::span(&size, 1));
}

std::size_t number_in(std::string_view digits) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw std::runtime_error(fmt::format("'{}' is no whole number", digits));
  return value;
}

/// Computes the checksums of a file in its present state.
class Taken {
public:
  explicit Taken(const std::filesystem::path& file) : run_(file) {}

  Checksum like(const Checksum& known) {
    const std::string_view path = known.path;
    if (path.starts_with(frames)) {
      const std::size_t frame = number_in(path.substr(frames.size()));
      return of_fields(known, frame, run_.frame_fields(frame),
                       [&](const std::string& name) { return run_.frame_field(frame, name); });
    }
    for (const std::string_view part : frame_parts)
      if (const std::string group = fmt::format("/{}/", part); path.starts_with(group)) {
        const std::size_t frame = number_in(path.substr(group.size()));
        return of_fields(known, frame, run_.part_fields(part, frame),
                         [&](const std::string& name) { return run_.part_field(part, frame, name); });
      }
    if (path.starts_with(boundary))
      return beginning({known.path}, exchange(path.substr(boundary.size())), known.numbers);
    const SeriesData data = run_.series(path);
    return beginning(checksum_of_series(path, data.columns, data.units), data.values, known.numbers);
  }

private:
  /// Adds the first `numbers` values, or all if there are fewer.
  static Checksum beginning(Checksum checksum, const std::vector<double>& values, std::size_t numbers) {
    checksum.add(std::span(values).first(std::min(numbers, values.size())));
    return checksum;
  }

  template <class Read>
  Checksum of_fields(const Checksum& known, std::size_t frame, const std::vector<std::string>& names,
                     const Read& read) {
    return checksum_of_fields(known.path, run_.frame_times().at(frame), StoredFields(names, read).fields());
  }

  const std::vector<double>& exchange(std::string_view name) {
    if (!boundary_)
      boundary_ = run_.boundary();
    return name == "time"                  ? boundary_->time
           : name == "free_field_velocity" ? boundary_->free_field_velocity
           : name == "domain_velocity"     ? boundary_->domain_velocity
                                           : boundary_->traction;
  }

  RunReader run_;
  std::optional<BoundaryHistory> boundary_;
};

} // namespace

void Checksum::add(std::span<const double> values) {
  numbers += values.size();
  crc = extended(crc, values);
}

Checksum checksum_of_series(std::string_view path, std::span<const std::string> columns,
                            std::span<const std::string> units) {
  Checksum checksum{std::string(path)};
  for (const auto& texts : {columns, units})
    for (const std::string& text : texts)
      checksum.crc = extended(checksum.crc, text);
  return checksum;
}

FieldsChecksum::FieldsChecksum(std::string_view path, double time) : checksum_{std::string(path)} {
  checksum_.crc = extended(checksum_.crc, std::span<const double>(&time, 1));
}

void FieldsChecksum::begin(std::string_view name, std::string_view unit, std::size_t components,
                           bool integers, std::size_t count) {
  const std::array shape{components, integers ? sizeof(std::int32_t) : sizeof(double), count};
  checksum_.crc = extended(extended(checksum_.crc, name), unit);
  checksum_.crc = extended(checksum_.crc, std::span<const std::size_t>(shape));
  checksum_.numbers += count;
}

void FieldsChecksum::add(FieldValues values) {
  std::visit([&](auto span) { checksum_.crc = extended(checksum_.crc, span); }, values);
}

Checksum checksum_of_fields(std::string_view path, double time, std::span<const Field> fields) {
  std::vector<const Field*> by_name;
  for (const Field& field : fields)
    by_name.push_back(&field);
  std::ranges::sort(by_name, {}, [](const Field* field) { return field->name; });
  FieldsChecksum sum(path, time);
  for (const Field* field : by_name) {
    sum.begin(field->name, field->unit, field->components,
              std::holds_alternative<std::span<const std::int32_t>>(field->values), value_count(*field));
    sum.add(field->values);
  }
  return sum.checksum();
}

std::string checksum_text(std::span<const Checksum> checksums) {
  std::string text;
  for (const Checksum& checksum : checksums)
    text += fmt::format("{:08x} {} {}\n", checksum.crc, checksum.numbers, checksum.path);
  return text;
}

std::vector<Checksum> checksums_from(std::string_view text) {
  std::vector<Checksum> checksums;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Checksum checksum;
    words >> std::hex >> checksum.crc >> std::dec >> checksum.numbers >> std::ws;
    if (!words || !std::getline(words, checksum.path))
      throw std::runtime_error(fmt::format("'{}' is no checksum of a dataset", line));
    checksums.push_back(std::move(checksum));
  }
  return checksums;
}

void require_undamaged(const std::filesystem::path& file, std::span<const Checksum> checksums) {
  Taken taken(file);
  for (const Checksum& known : checksums)
    if (const Checksum found = taken.like(known); found != known)
      throw std::runtime_error(
          fmt::format("{} is not what was written: CRC-32 {:08x} over {} numbers, it was {:08x} over {}",
                      known.path, found.crc, found.numbers, known.crc, known.numbers));
}

} // namespace tremolo::results
