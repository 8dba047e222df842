// VTKHDF (docs.vtk.org, "VTKHDF file format", 2.0), type UnstructuredGrid with Steps. All arrays run through
// all parts of all times, one after the other; a part's connectivity begins at 0, and its offsets are one
// more than its cells. Steps says where a time begins in each of them.

#include "results/paraview/vtkhdf.hpp"

#include "results/hdf5/hdf5_read.hpp"
#include "results/hdf5/hdf5_write.hpp"
#include "results/paraview/shapes.hpp"
#include "results/paraview/virtual_array.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

namespace tremolo::results {
namespace {

constexpr std::uint8_t vtk_vertex = 1;
constexpr std::uint8_t vtk_poly_line = 4;
/// Arrays that /VTKHDF maps and that no other part of a run holds.
constexpr const char* own_group = "/paraview";

/// A field of the frames.
struct FrameField {
  hsize_t columns = 0; ///< 0: a scalar
  bool real = true;
};

struct Frame {
  std::string path;
  double time = 0.0;
  hsize_t points = 0; ///< of the soil
  std::map<std::string, FrameField> fields;
  std::string structures; ///< path of the particles of elastic structures
  hsize_t of_structures = 0;
  std::map<std::string, FrameField> fields_of_structures;

  hsize_t vertices() const { return points + of_structures; }
};

/// Finds the fields of a group, and how many points they have.
std::pair<std::map<std::string, FrameField>, hsize_t> fields_in(const FileReader& run,
                                                                const std::string& group) {
  std::map<std::string, FrameField> fields;
  hsize_t points = 0;
  for (const std::string& field : run.children(group)) {
    const Handle dataset = run.dataset(group + "/" + field);
    const Handle space(H5Dget_space(dataset.get()), H5Sclose);
    const Handle type(H5Dget_type(dataset.get()), H5Tclose);
    const auto shape = run.shape(space.get());
    fields[field] = {shape.size() > 1 ? shape[1] : 0, H5Tget_class(type.get()) == H5T_FLOAT};
    points = shape[0];
  }
  return {std::move(fields), points};
}

std::vector<Frame> frames_of(const FileReader& run) {
  std::vector<Frame> frames;
  const bool have_structures = run.exists("structures");
  for (const std::string& name : run.children("frames")) {
    Frame& frame = frames.emplace_back();
    frame.path = "/frames/" + name;
    frame.time = run.attribute_as<double>(frame.path, "time");
    std::tie(frame.fields, frame.points) = fields_in(run, frame.path);
    if (have_structures) {
      frame.structures = "/structures/" + name;
      std::tie(frame.fields_of_structures, frame.of_structures) = fields_in(run, frame.structures);
    }
  }
  return frames;
}

/// Numbers as a dataset of one dimension, or of as many columns.
template <class Number>
void write_numbers(Place place, const std::string& name, hid_t type, const std::vector<Number>& numbers,
                   hsize_t columns = 0) {
  const std::array<hsize_t, 2> shape{numbers.size() / std::max<hsize_t>(columns, 1), columns};
  const Handle space(H5Screate_simple(columns == 0 ? 1 : 2, shape.data(), nullptr), H5Sclose);
  const Handle dataset(checked(H5Dcreate2(place.object, name.c_str(), type, space.get(), H5P_DEFAULT,
                                          H5P_DEFAULT, H5P_DEFAULT),
                               place.file, "write " + name),
                       H5Dclose);
  checked(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), place.file,
          "write " + name);
}

void write_raw_attribute(Place place, const char* name, hid_t type, hid_t space, const void* value) {
  const Handle attribute(
      checked(H5Acreate2(place.object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), place.file, name),
      H5Aclose);
  checked(H5Awrite(attribute.get(), type, value), place.file, name);
}

/// Version and type, as the format wants them: two integers, and a string of ASCII.
void write_head(Place group) {
  constexpr std::array<std::int64_t, 2> version{2, 0};
  constexpr std::string_view name = "UnstructuredGrid";
  constexpr hsize_t two = 2;
  const Handle pair(H5Screate_simple(1, &two, nullptr), H5Sclose);
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(text.get(), name.size());
  write_raw_attribute(group, "Version", H5T_NATIVE_INT64, pair.get(), version.data());
  write_raw_attribute(group, "Type", text.get(), scalar.get(), name.data());
}

class Writer {
public:
  Writer(const Handle& file, const std::filesystem::path& path, std::span<const Frame> frames,
         const Shapes& shapes)
      : path_(path), frames_(frames), shapes_(shapes), root_{file.get(), path_},
        own_(create_group(root_, own_group, 8)), group_(create_group(root_, "VTKHDF", 16)),
        points_(create_group(grid(), "PointData", 16)), steps_(create_group(grid(), "Steps", 16)) {}

  void write() {
    write_head(grid());
    write_own();
    write_sizes();
    write_topology();
    for (const auto& [name, field] : frames_.front().fields)
      if (name != "position")
        write_field(name, field);
    write_parts();
    write_steps();
  }

private:
  Place grid() const { return {group_.get(), path_}; }
  hsize_t lines() const { return shapes_.offsets.size() - 1; }
  bool has_shapes() const { return shapes_.count() > 0; }
  /// Adds up, over all times, something of the particles' part and something of the shapes'.
  hsize_t sum(hsize_t of_shapes, hsize_t more = 0) const {
    hsize_t all = 0;
    for (const Frame& frame : frames_)
      all += frame.vertices() + more + (has_shapes() ? of_shapes : 0);
    return all;
  }
  hsize_t most_of_structures() const {
    return std::ranges::max(frames_, {}, &Frame::of_structures).of_structures;
  }
  SourceRows own(const char* name, hsize_t all, hsize_t count, hsize_t columns = 0, hsize_t first = 0) const {
    return {std::string(own_group) + "/" + name, all, columns, count, first};
  }

  void write_own() {
    const Place place{own_.get(), path_};
    most_ = std::ranges::max(frames_, {}, &Frame::vertices).vertices() + 1;
    std::vector<std::int64_t> numbers(most_);
    std::iota(numbers.begin(), numbers.end(), 0);
    write_numbers(place, "numbers", H5T_NATIVE_INT64, numbers);
    if (most_of_structures() > 0)
      write_numbers(place, "of_structures", H5T_NATIVE_INT32,
                    std::vector<std::int32_t>(most_of_structures(), part_of_structures));
    if (!has_shapes())
      return;
    write_numbers(place, "connectivity", H5T_NATIVE_INT64, shapes_.connectivity);
    write_numbers(place, "offsets", H5T_NATIVE_INT64, shapes_.offsets);
    write_numbers(place, "types", H5T_NATIVE_UINT8, std::vector<std::uint8_t>(lines(), vtk_poly_line));
    write_numbers(place, "parts", H5T_NATIVE_INT32, shapes_.parts);
    write_numbers(place, "fixed", H5T_NATIVE_DOUBLE, shapes_.fixed, 3);
    write_numbers(place, "moving", H5T_NATIVE_DOUBLE, shapes_.moving, 3);
  }

  void write_sizes() {
    std::vector<std::int64_t> points, cells, connectivity;
    for (const Frame& frame : frames_)
      for (auto* sizes : {&points, &cells, &connectivity})
        sizes->push_back(static_cast<std::int64_t>(frame.vertices()));
    if (has_shapes())
      for (std::size_t k = frames_.size(); k > 0; --k) {
        const auto place = static_cast<std::ptrdiff_t>(k);
        points.insert(points.begin() + place, static_cast<std::int64_t>(shapes_.count()));
        cells.insert(cells.begin() + place, static_cast<std::int64_t>(lines()));
        connectivity.insert(connectivity.begin() + place,
                            static_cast<std::int64_t>(shapes_.connectivity.size()));
      }
    write_numbers(grid(), "NumberOfPoints", H5T_NATIVE_INT64, points);
    write_numbers(grid(), "NumberOfCells", H5T_NATIVE_INT64, cells);
    write_numbers(grid(), "NumberOfConnectivityIds", H5T_NATIVE_INT64, connectivity);
  }

  void write_topology() {
    const hsize_t ids = shapes_.connectivity.size();
    const hsize_t fixed = shapes_.fixed.size() / 3;
    const hsize_t moving = shapes_.count() - fixed;
    VirtualArray points(sum(shapes_.count()), 3), connectivity(sum(ids), 0), types(sum(lines()), 0);
    VirtualArray offsets(sum(lines() + 1, 1), 0);
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      const Frame& frame = frames_[k];
      points.append({frame.path + "/position", frame.points, 2, frame.points});
      points.append({frame.structures + "/position", frame.of_structures, 2, frame.of_structures});
      connectivity.append(own("numbers", most_, frame.vertices()));
      offsets.append(own("numbers", most_, frame.vertices() + 1));
      types.skip(frame.vertices());
      if (!has_shapes())
        continue;
      points.append(own("fixed", fixed, fixed, 3));
      points.append(own("moving", moving * frames_.size(), moving, 3, k * moving));
      connectivity.append(own("connectivity", ids, ids));
      offsets.append(own("offsets", lines() + 1, lines() + 1));
      types.append(own("types", lines(), lines()));
    }
    constexpr double nowhere = 0.0;
    constexpr std::int64_t none = 0;
    points.write(grid(), "Points", H5T_NATIVE_DOUBLE, &nowhere);
    connectivity.write(grid(), "Connectivity", H5T_NATIVE_INT64, &none);
    offsets.write(grid(), "Offsets", H5T_NATIVE_INT64, &none);
    types.write(grid(), "Types", H5T_NATIVE_UINT8, &vtk_vertex);
  }

  /// A field of the soil, and of structures where they have it; elsewhere it is 0.
  void write_field(const std::string& name, const FrameField& field) {
    constexpr double zero = 0.0;
    constexpr std::int32_t none = 0;
    const hsize_t columns = field.columns == 2 ? 3 : field.columns == 4 ? 6 : field.columns;
    VirtualArray values(sum(shapes_.count()), columns);
    const auto add = [&](const std::string& group, const auto& fields, hsize_t count) {
      if (fields.contains(name))
        values.append({group + "/" + name, count, field.columns, count});
      else
        values.skip(count);
    };
    for (const Frame& frame : frames_) {
      add(frame.path, frame.fields, frame.points);
      add(frame.structures, frame.fields_of_structures, frame.of_structures);
      values.skip(shapes_.count());
    }
    values.write({points_.get(), path_}, name, field.real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT32,
                 field.real ? static_cast<const void*>(&zero) : &none);
  }

  void write_parts() {
    constexpr std::int32_t soil = 0;
    VirtualArray parts(sum(shapes_.count()), 0);
    for (const Frame& frame : frames_) {
      parts.skip(frame.points);
      parts.append(own("of_structures", most_of_structures(), frame.of_structures));
      if (has_shapes())
        parts.append(own("parts", shapes_.count(), shapes_.count()));
    }
    parts.write({points_.get(), path_}, "part", H5T_NATIVE_INT32, &soil);
  }

  void write_steps() {
    const Place place{steps_.get(), path_};
    const std::int64_t parts = has_shapes() ? 2 : 1;
    std::vector<double> values;
    std::vector<std::int64_t> part_offsets, part_counts, points, cells, connectivity;
    std::int64_t point = 0, cell = 0, id = 0;
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      values.push_back(frames_[k].time);
      part_offsets.push_back(static_cast<std::int64_t>(k) * parts);
      part_counts.push_back(parts);
      points.push_back(point);
      cells.push_back(cell);
      connectivity.push_back(id);
      const auto vertices = static_cast<std::int64_t>(frames_[k].vertices());
      point += vertices + static_cast<std::int64_t>(shapes_.count());
      cell += vertices + static_cast<std::int64_t>(lines());
      id += vertices + static_cast<std::int64_t>(shapes_.connectivity.size());
    }
    write_attribute(place, "NSteps", static_cast<std::int64_t>(frames_.size()));
    write_numbers(place, "Values", H5T_NATIVE_DOUBLE, values);
    write_numbers(place, "PartOffsets", H5T_NATIVE_INT64, part_offsets);
    write_numbers(place, "NumberOfParts", H5T_NATIVE_INT64, part_counts);
    write_numbers(place, "PointOffsets", H5T_NATIVE_INT64, points);
    write_numbers(place, "CellOffsets", H5T_NATIVE_INT64, cells, 1);
    write_numbers(place, "ConnectivityIdOffsets", H5T_NATIVE_INT64, connectivity, 1);
    const Handle offsets = create_group(place, "PointDataOffsets", 16);
    for (const auto& [name, field] : frames_.front().fields)
      if (name != "position")
        write_numbers({offsets.get(), path_}, name, H5T_NATIVE_INT64, points);
    write_numbers({offsets.get(), path_}, "part", H5T_NATIVE_INT64, points);
  }

  const std::filesystem::path& path_;
  std::span<const Frame> frames_;
  const Shapes& shapes_;
  Place root_;
  Handle own_;
  Handle group_;
  Handle points_;
  Handle steps_;
  hsize_t most_ = 0; ///< numbers that are there to be mapped
};

} // namespace

void add_vtkhdf(const std::filesystem::path& run_file) {
  std::vector<Frame> frames;
  Shapes shapes;
  {
    const FileReader run(run_file, "run file");
    frames = frames_of(run);
    if (frames.empty() || frames.size() > most_vtk_frames)
      return;
    std::vector<double> times;
    for (const Frame& frame : frames)
      times.push_back(frame.time);
    shapes = shapes_of(run, times);
  }
  const Handle file = open_for_virtual_datasets(run_file);
  { Writer(file, run_file, frames, shapes).write(); }
  flush_file(file, run_file);
}

} // namespace tremolo::results
