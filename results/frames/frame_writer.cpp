#include "results/frames/frame_writer.hpp"

#include "results/hdf5/array_in_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::results {
namespace {

bool are_integers(FieldValues values) {
  return std::holds_alternative<std::span<const std::int32_t>>(values);
}

/// Writes the values of a field, which go into the checksum on their way.
void write_values(Place group, const StreamedField& field, std::size_t points, FieldsChecksum& checksum) {
  std::vector<hsize_t> shape{points};
  if (field.components > 1) {
    shape.push_back(field.components);
  }
  const std::size_t count = points * field.components;
  const std::size_t bytes = count * (field.integers ? sizeof(std::int32_t) : sizeof(double));
  ArrayInPieces array(group, field.name, field.integers ? H5T_NATIVE_INT32 : H5T_NATIVE_DOUBLE, shape,
                      compressed_layout(bytes));
  checksum.begin(field.name, field.unit, field.components, field.integers, count);
  field.give([&](FieldValues piece) {
    if (are_integers(piece) != field.integers) {
      throw std::invalid_argument(fmt::format("field {} mixes integers and real numbers", field.name));
    }
    array.add(piece);
    checksum.add(piece);
  });
  array.finish(field.unit);
}

} // namespace

void require_positions(const PointFields& of, std::size_t least) {
  const auto position = std::ranges::find(of.fields, "position", &StreamedField::name);
  if (position == of.fields.end() || position->components != 2 || of.points < least) {
    throw std::invalid_argument(fmt::format(
        "a frame needs the field position with 2 components and at least {} {}s", least, of.what));
  }
}

PointFields all_at_once(std::span<const Field> fields, std::string_view what, std::size_t least) {
  PointFields of{std::string(what), 0, {}};
  for (const Field& field : fields) {
    if (field.name == "position") {
      of.points = value_count(field) / 2;
    }
    of.fields.push_back({field.name, field.unit, field.components, are_integers(field.values),
                         [values = field.values](const auto& take) { take(values); }});
  }
  require_positions(of, least);
  for (const Field& field : fields) {
    if (value_count(field) != of.points * field.components) {
      throw std::invalid_argument(
          fmt::format("field {} has {} values where {} {}s with {} components need {}", field.name,
                      value_count(field), of.points, what, field.components, of.points * field.components));
    }
  }
  return of;
}

UnlinkedFields write_unlinked_fields(Place root, const std::string& path, double time,
                                     const PointFields& of) {
  Handle group(checked(H5Gcreate_anon(root.object, group_properties(of.fields.size()).get(), H5P_DEFAULT),
                       root.file, fmt::format("create {}", path)),
               H5Gclose);
  const Place place{group.get(), root.file};
  write_attribute(place, "time", time);
  std::vector<const StreamedField*> by_name; // as the checksum takes them
  for (const StreamedField& field : of.fields) {
    by_name.push_back(&field);
  }
  std::ranges::sort(by_name, {}, [](const StreamedField* field) { return field->name; });
  FieldsChecksum checksum(path, time);
  for (const StreamedField* field : by_name) {
    write_values(place, *field, of.points, checksum);
  }
  return {std::move(group), checksum.checksum()};
}

} // namespace tremolo::results
