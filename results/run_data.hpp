#pragma once

// Plain data that goes into and comes out of a run file.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::results {

using AttributeValue =
    std::variant<std::string, double, std::int64_t, std::vector<double>, std::vector<std::string>>;

/// An attribute of an object in the file.
struct Attribute {
  std::string name;
  AttributeValue value;
};

using FieldValues = std::variant<std::span<const double>, std::span<const std::int32_t>>;

/// A quantity of all particles of a frame, particle after particle.
struct Field {
  std::string_view name;
  std::string_view unit;      ///< SI, "1" for none
  std::size_t components = 1; ///< 1 scalar, 2 vector (x, y), 4 stress (xx, yy, zz, xy)
  FieldValues values;         ///< [particles * components]
};

inline std::size_t value_count(const Field& field) {
  return std::visit([](auto span) { return span.size(); }, field.values);
}

/// A field whose values are made while it is written, so that they never are all in memory.
struct StreamedField {
  std::string_view name;
  std::string_view unit;
  std::size_t components = 1;
  bool integers = false; ///< of 32 bits
  /// Passes all values to `take`, in order, in pieces of whole particles. It is called once.
  std::function<void(const std::function<void(FieldValues piece)>& take)> give;
};

/// Groups that frames may have besides the soil's particles: contact nodes, and particles of elastic
/// structures.
inline constexpr std::array<std::string_view, 2> frame_parts{"contact", "structures"};

/// Fields of one of them at the time of a frame; none: the run has no such part.
struct FramePart {
  std::string_view group; ///< one of frame_parts
  std::span<const Field> fields;
};

/// Describes a field in a file, whose values have not been read.
struct FieldShape {
  std::string unit;
  std::size_t particles = 0;
  std::size_t components = 1;
  bool integers = false; ///< of 32 bits
};

/// A field as read.
struct FieldData {
  std::string unit;
  std::size_t components = 1;
  std::vector<double> values; ///< [particles * components]
  bool integers = false;      ///< they are whole numbers of 32 bits in the file
};

/// The boundary exchange as read: time after time, all faces.
struct BoundaryHistory {
  std::vector<double> time;                ///< s
  std::vector<double> free_field_velocity; ///< [times * faces * 2], as the others, m/s
  std::vector<double> domain_velocity;     ///< m/s
  std::vector<double> traction;            ///< Pa
};

/// A time series as read.
struct SeriesData {
  std::vector<std::string> columns;
  std::vector<std::string> units;
  std::vector<double> values; ///< [rows * columns], row after row

  std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
  bool has(std::string_view column) const { return std::ranges::find(columns, column) != columns.end(); }

  /// @throws std::runtime_error where there is no such column
  std::vector<double> column(std::string_view name) const;
};

/// The faces through which the domain is shaken, in the order of the exchange.
struct BoundaryFaces {
  std::vector<double> position;    ///< [faces * 2] at the start of shaking, m
  std::vector<double> normal;      ///< [faces * 2] outward, 1
  std::vector<double> length;      ///< [faces] m
  std::vector<std::string> source; ///< [faces] the participant that serves the face
};

/// Velocities and tractions at the faces at one time; all arrays [faces * 2].
struct BoundarySample {
  std::span<const double> free_field_velocity; ///< v^ff, m/s
  std::span<const double> domain_velocity;     ///< v^m, m/s
  std::span<const double> traction;            ///< on the domain, Pa
};

/// Named columns of equal length.
struct Table {
  struct Column {
    std::string name;
    std::string unit; ///< SI, "1" for none
    std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>> values;
  };
  std::vector<Column> columns;
};

} // namespace tremolo::results
