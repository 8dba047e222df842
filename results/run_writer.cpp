#include "results/checkpoint_file.hpp"
#include "results/frames/frame_writer.hpp"
#include "results/frames/xdmf.hpp"
#include "results/hdf5/array_in_pieces.hpp"
#include "results/hdf5/growing_dataset.hpp"
#include "results/hdf5/hdf5_write.hpp"
#include "results/paraview/vtkhdf.hpp"
#include "results/run_file.hpp"
#include "results/run_status.hpp"

#include <unistd.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <stdexcept>

namespace tremolo::results {
namespace {

/// Room for links in /frames and /contact, and in /monitors and other groups of series; more are possible,
/// but no longer added by a single write.
constexpr std::size_t expected_frames = 4096;
constexpr std::size_t expected_monitors = 64;

/// What the points of a frame are, for messages.
constexpr std::string_view particle = "particle";

std::string host_name() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

std::string utc_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()));
}

/// A growing array of /boundary, and its rows that wait for a flush.
struct BoundaryDataset {
  BoundaryDataset(Place group, std::string_view name, std::span<const hsize_t> row_shape,
                  std::string_view unit)
      : dataset(group, name, row_shape), checksum{fmt::format("/boundary/{}", name)} {
    write_attribute({dataset.id(), group.file}, "unit", std::string(unit));
  }

  void keep(std::span<const double> row) {
    if (row.size() != dataset.row_size()) {
      throw std::invalid_argument(fmt::format("{} has {} values where {} faces need {}", checksum.path,
                                              row.size(), dataset.row_size() / 2, dataset.row_size()));
    }
    pending.insert(pending.end(), row.begin(), row.end());
    checksum.add(row);
  }

  void write_pending() {
    dataset.append(pending);
    pending.clear();
  }

  GrowingDataset dataset;
  Checksum checksum;
  std::vector<double> pending;
};

/// The growing datasets below /boundary; the time is written last.
std::vector<BoundaryDataset> boundary_datasets(Place group, hsize_t faces) {
  const std::array<hsize_t, 2> vectors{faces, 2};
  std::vector<BoundaryDataset> datasets;
  datasets.emplace_back(group, "free_field_velocity", vectors, "m/s");
  datasets.emplace_back(group, "domain_velocity", vectors, "m/s");
  datasets.emplace_back(group, "traction", vectors, "Pa");
  datasets.emplace_back(group, "time", std::span<const hsize_t>(), "s");
  return datasets;
}

} // namespace

void TimeSeries::append(std::span<const double> row) {
  if (row.size() != columns_) {
    throw std::invalid_argument(
        fmt::format("a row of {} has {} values where {} are needed", checksum_.path, row.size(), columns_));
  }
  checksum_.add(row);
  pending_.insert(pending_.end(), row.begin(), row.end());
}

class RunWriter::Implementation {
public:
  Implementation(const std::filesystem::path& path, const RunDescription& description)
      : path_(path), file_(create_draft(path_)), frames_(create_group(root(), "frames", expected_frames)),
        monitors_(create_group(root(), "monitors", expected_monitors)) {
    if (description.content.empty()) {
      xdmf_.emplace(path_);
    } else {
      write_attribute(root(), "content", description.content);
    }
    create_status(root());
    write_attribute(root(), "schema_version", std::string(schema_version));
    write_attribute(root(), "title", description.title);
    write_attribute(root(), "build_version", description.build_version);
    write_attribute(root(), "compiler", description.compiler);
    write_attribute(root(), "build_flags", description.build_flags);
    write_attribute(root(), "host", host_name());
    write_attribute(root(), "started", utc_now());
    write_text(root(), "case", description.case_text);
    write_text(root(), "plan", description.plan);
    publish_draft(file_, path_);
  }

  Place root() const { return {file_.get(), path_}; }

  /// Runs an action that writes. When it fails, the file is left as the last flush made it.
  template <class Action>
  void guarded(Action action) {
    if (file_.get() < 0) {
      throw std::invalid_argument(fmt::format("{}: the run is already closed", path_.string()));
    }
    guard_(file_, action);
  }

  void require_new(std::string_view path) const {
    if (H5Lexists(file_.get(), std::string(path).c_str(), H5P_DEFAULT) > 0) {
      throw std::invalid_argument(fmt::format("{} is in the run already", path));
    }
  }

  /// Creates the group in which a path ends, where it is not there yet.
  void require_group_of(std::string_view path) const {
    const std::string group(path.substr(0, path.rfind('/')));
    if (!group.empty() && H5Lexists(file_.get(), group.c_str(), H5P_DEFAULT) <= 0) {
      create_group(root(), group, expected_monitors);
    }
  }

  void attribute(std::string_view name, const AttributeValue& value) {
    if (H5Aexists(file_.get(), std::string(name).c_str()) > 0) {
      throw std::invalid_argument(fmt::format("attribute {} is in the run already", name));
    }
    write_attribute(root(), name, value);
  }

  void require_no_frame(std::string_view what) const {
    if (frame_count_ > 0) {
      throw std::invalid_argument(fmt::format("{} must be declared before the first frame", what));
    }
  }

  TimeSeries& add_series(std::string_view path, std::span<const std::string> columns,
                         std::span<const std::string> units, std::span<const Attribute> attributes,
                         std::unique_ptr<TimeSeries> series) {
    if (columns.empty() || columns.size() != units.size()) {
      throw std::invalid_argument(
          fmt::format("series {} has {} columns and {} units", path, columns.size(), units.size()));
    }
    require_group_of(path);
    require_new(path);
    const hsize_t width = columns.size();
    GrowingDataset dataset(root(), path, {&width, 1});
    const Place place{dataset.id(), path_};
    write_attribute(place, "columns", std::vector<std::string>(columns.begin(), columns.end()));
    write_attribute(place, "units", std::vector<std::string>(units.begin(), units.end()));
    for (const Attribute& attribute : attributes) {
      write_attribute(place, attribute.name, attribute.value);
    }
    series_.push_back({std::move(series), std::move(dataset)});
    return *series_.back().buffer;
  }

  void set_boundary(const BoundaryFaces& faces) {
    const hsize_t count = faces.length.size();
    if (faces.position.size() != 2 * count || faces.normal.size() != 2 * count ||
        faces.source.size() != count || count == 0) {
      throw std::invalid_argument(
          "the boundary needs position, normal, length and source of at least one face");
    }
    require_new("/boundary");
    constexpr std::size_t datasets = 8;
    const Handle group = create_group_of_long_attributes(root(), "boundary", datasets); // `source`
    const Place place{group.get(), path_};
    const std::array<hsize_t, 2> vectors{count, 2};
    const std::array<hsize_t, 1> scalars{count};
    write_array(place, "position", vectors, std::span(faces.position), "m", false);
    write_array(place, "normal", vectors, std::span(faces.normal), "1", false);
    write_array(place, "length", scalars, std::span(faces.length), "m", false);
    write_attribute(place, "source", faces.source);
    boundary_ = boundary_datasets(place, count);
  }

  void append_boundary(double time, const BoundarySample& exchange) {
    if (boundary_.empty()) {
      throw std::invalid_argument("the boundary faces must be declared before their exchange is written");
    }
    auto dataset = boundary_.begin();
    for (const std::span<const double> row : {exchange.free_field_velocity, exchange.domain_velocity,
                                              exchange.traction, std::span<const double>(&time, 1)}) {
      (dataset++)->keep(row);
    }
  }

  /// The frame and its parts beside the soil are written and flushed before anything refers to them; then a
  /// link each makes them part of the run, the frame last.
  void write_frame(double time, const PointFields& soil, std::span<const FramePart> parts) {
    if (!xdmf_) {
      throw std::invalid_argument(fmt::format("{}: this file takes no frames", path_.string()));
    }
    const std::string name = fmt::format("{:04}", frame_count_);
    std::vector<UnlinkedFields> beside;
    std::vector<std::string_view> groups;
    for (const FramePart& part : parts) {
      if (part.fields.empty()) {
        continue;
      }
      const PointFields points = all_at_once(part.fields, fmt::format("point of {}", part.group), 0);
      groups.push_back(part.group);
      beside.push_back(write_unlinked_fields(root(), fmt::format("/{}/{}", part.group, name), time, points));
    }
    const UnlinkedFields frame = write_unlinked_fields(root(), "/frames/" + name, time, soil);
    for (std::size_t i = 0; i < beside.size(); ++i) {
      publish(beside[i].group, group_of_part(groups[i]), name);
    }
    publish(frame.group, frames_, name);
    frames_written_.push_back(frame.checksum);
    for (const UnlinkedFields& part : beside) {
      frames_written_.push_back(part.checksum);
    }
    ++frame_count_;
    std::vector<XdmfField> xdmf_fields;
    for (const StreamedField& field : soil.fields) {
      xdmf_fields.push_back({std::string(field.name), field.components, !field.integers});
    }
    xdmf_->add_frame(time, "/frames/" + name, soil.points, xdmf_fields);
  }

  void table(std::string_view path, const Table& table) {
    require_new(path);
    publish(write_unlinked_table(root(), table), file_, std::string(path));
  }

  void flush() {
    for (auto& [buffer, dataset] : series_) {
      dataset.append(buffer->pending_);
      buffer->pending_.clear();
    }
    for (BoundaryDataset& dataset : boundary_) {
      dataset.write_pending();
    }
    flush_file(file_, path_);
  }

  void flush_if_large() {
    constexpr std::size_t most_waiting = (std::size_t{1} << 20) / sizeof(double);
    std::size_t waiting = 0;
    for (const BoundaryDataset& dataset : boundary_) {
      waiting += dataset.pending.size();
    }
    for (const auto& [buffer, dataset] : series_) {
      waiting += buffer->pending_.size();
    }
    if (waiting > most_waiting) {
      flush();
    }
  }

  void close(std::string_view status) {
    set_status(root(), status);
    flush();
    close_handles();
  }

  std::size_t frame_count() const { return frame_count_; }

  std::vector<Checksum> checksums() const {
    std::vector<Checksum> all;
    for (const auto& [buffer, dataset] : series_) {
      all.push_back(buffer->checksum_);
    }
    for (const BoundaryDataset& dataset : boundary_) {
      all.push_back(dataset.checksum);
    }
    all.insert(all.end(), frames_written_.begin(), frames_written_.end());
    return all;
  }

private:
  struct Series {
    std::unique_ptr<TimeSeries> buffer;
    GrowingDataset dataset;
  };

  /// The group of what frames have beside soil, created with the first of it.
  const Handle& group_of_part(std::string_view name) {
    auto group = parts_.find(name);
    if (group == parts_.end()) {
      group = parts_.emplace(name, create_group(root(), std::string(name), expected_frames)).first;
    }
    return group->second;
  }

  void publish(const Handle& object, const Handle& parent, const std::string& name) {
    flush();
    checked(H5Olink(object.get(), parent.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), path_,
            "add " + name);
    flush_file(file_, path_);
  }

  void close_handles() {
    boundary_.clear();
    series_.clear();
    monitors_ = Handle();
    parts_.clear();
    frames_ = Handle();
    file_ = Handle();
  }

  std::filesystem::path path_;
  Handle file_;
  WriteGuard guard_;
  Handle frames_;
  std::map<std::string_view, Handle> parts_; ///< groups of frame_parts
  Handle monitors_;
  std::vector<Series> series_;
  std::vector<BoundaryDataset> boundary_;
  std::vector<Checksum> frames_written_; ///< with their parts
  std::size_t frame_count_ = 0;
  std::optional<XdmfFile> xdmf_; ///< none of a file that takes no frames
};

RunWriter::RunWriter(const std::filesystem::path& file, const RunDescription& description)
    : implementation_(std::make_unique<Implementation>(file, description)) {}

RunWriter::~RunWriter() = default;

void RunWriter::attribute(std::string_view name, const AttributeValue& value) {
  implementation_->require_no_frame("an attribute");
  implementation_->guarded([&] { implementation_->attribute(name, value); });
}

TimeSeries& RunWriter::add_series(std::string_view path, std::span<const std::string> columns,
                                  std::span<const std::string> units, std::span<const Attribute> attributes) {
  implementation_->require_no_frame("a series");
  std::unique_ptr<TimeSeries> series(
      new TimeSeries(checksum_of_series(path, columns, units), columns.size()));
  TimeSeries* added = nullptr;
  implementation_->guarded(
      [&] { added = &implementation_->add_series(path, columns, units, attributes, std::move(series)); });
  return *added;
}

void RunWriter::set_boundary(const BoundaryFaces& faces) {
  implementation_->require_no_frame("the boundary");
  implementation_->guarded([&] { implementation_->set_boundary(faces); });
}

void RunWriter::append_boundary(double time, const BoundarySample& exchange) {
  implementation_->append_boundary(time, exchange);
}

void RunWriter::write_frame(double time, std::span<const Field> fields, std::span<const FramePart> parts) {
  implementation_->guarded(
      [&] { implementation_->write_frame(time, all_at_once(fields, particle, 1), parts); });
}

void RunWriter::write_frame(double time, std::size_t particles, std::vector<StreamedField> fields,
                            std::span<const FramePart> parts) {
  const PointFields soil{std::string(particle), particles, std::move(fields)};
  implementation_->guarded([&] {
    require_positions(soil, 1);
    implementation_->write_frame(time, soil, parts);
  });
}

void RunWriter::flush() {
  implementation_->guarded([&] { implementation_->flush(); });
}

void RunWriter::flush_if_large() {
  implementation_->guarded([&] { implementation_->flush_if_large(); });
}

void RunWriter::sync() {
  flush();
  sync_to_disk(implementation_->root().file);
}

void RunWriter::table(std::string_view path, const Table& table) {
  implementation_->guarded([&] { implementation_->table(path, table); });
}

std::optional<std::string> RunWriter::finish() {
  implementation_->guarded([&] { implementation_->close(status_complete); });
  if (frame_count() == 0)
    return std::nullopt;
  try {
    add_vtkhdf(implementation_->root().file);
  } catch (const std::runtime_error& error) { // all results are there already
    return fmt::format("the results are complete, but for /VTKHDF, which ParaView opens: {}", error.what());
  }
  return std::nullopt;
}

void RunWriter::abort(std::string_view reason) {
  implementation_->guarded([&] { implementation_->close(aborted_status(reason)); });
}

std::size_t RunWriter::frame_count() const {
  return implementation_->frame_count();
}

std::vector<Checksum> RunWriter::checksums() const {
  return implementation_->checksums();
}

} // namespace tremolo::results
