#include "results/exchange_file.hpp"

#include "results/exchange_layout.hpp"
#include "results/hdf5/array_in_pieces.hpp"
#include "results/hdf5/growing_dataset.hpp"
#include "results/hdf5/hdf5_read.hpp"
#include "results/run_status.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>

namespace tremolo::results {
namespace {

/// A dataset of rows that are kept until they fill a chunk, so that no chunk is ever compressed twice.
class PackedRows {
public:
  PackedRows(Place place, std::string_view name, std::span<const hsize_t> row_shape, hsize_t chunk_rows,
             std::string_view unit)
      : name_(name), dataset_(place, name, row_shape, Storage::packed, chunk_rows) {
    write_attribute({dataset_.id(), place.file}, "unit", std::string(unit));
  }

  hid_t id() const { return dataset_.id(); }

  void append(std::span<const double> values) {
    kept_.insert(kept_.end(), values.begin(), values.end());
    const std::size_t chunk = dataset_.chunk_rows() * dataset_.row_size();
    const std::size_t whole = kept_.size() / chunk * chunk;
    dataset_.append(std::span(kept_).first(whole));
    written_ += whole / dataset_.row_size();
    kept_.erase(kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(whole));
  }

  void write_kept() {
    dataset_.append(kept_);
    kept_.clear();
  }

  void save(CheckpointWriter& checkpoint) const {
    checkpoint.write(name_ + ".written", std::span<const std::uint64_t>(&written_, 1));
    checkpoint.write(name_ + ".kept", std::span<const double>(kept_));
  }

  /// @param group of the dataset in the file before
  void take_over(const FileReader& before, const std::string& group, const CheckpointReader& checkpoint) {
    const std::string path = fmt::format("{}/{}", group, name_);
    const Handle dataset = before.dataset(path);
    const std::uint64_t rows = checkpoint.integers(name_ + ".written").at(0);
    const std::uint64_t chunk = dataset_.chunk_rows();
    for (std::uint64_t first = 0; first < rows; first += chunk) {
      append(before.rows<double>(dataset, H5T_NATIVE_DOUBLE, first, std::min(chunk, rows - first), path));
    }
    append(checkpoint.numbers(name_ + ".kept"));
  }

private:
  std::string name_;
  GrowingDataset dataset_;
  std::uint64_t written_ = 0; ///< rows in the file
  std::vector<double> kept_;
};

constexpr const char* domain_group = "domain";

/// Numbers of the chunks of all datasets of a track together, 1 MiB; they hold the same steps.
constexpr hsize_t chunk_values = 131072;

/// The frames of one sender and field: their values, spread over one dataset a quantity, and their headers.
class Track {
public:
  /// @param prefix numbers of a step before those of its points: 0, or 1 for the time
  Track(Place place, std::span<const Quantity> quantities, std::string_view frames, std::size_t points,
        std::size_t prefix)
      : quantities_(quantities), points_(points), prefix_(prefix) {
    for (const Quantity& quantity : quantities_) {
      values_per_point_ += quantity.components;
    }
    const hsize_t rows = std::clamp<hsize_t>(chunk_values / (prefix_ + points_ * values_per_point_), 1, 1024);
    for (const Quantity& quantity : quantities_) {
      datasets_.emplace_back(place, quantity.name, std::array<hsize_t, 2>{points, quantity.components}, rows,
                             quantity.unit);
    }
    if (prefix_ > 0) {
      time_.emplace(place, "time", std::span<const hsize_t>{}, rows, "s");
    }
    const hsize_t columns = frame_columns;
    frames_.emplace(place, frames, std::span(&columns, 1), rows, "1");
    write_attribute({frames_->id(), place.file}, "columns",
                    std::vector<std::string>{"first_step", "steps", "crc32"});
  }

  void append(const RecordedFrame& frame, std::span<const double> values) {
    const std::size_t step_size = prefix_ + points_ * values_per_point_;
    if (values.size() != frame.steps * step_size) {
      throw std::invalid_argument(
          fmt::format("a frame of {} steps of {} values has {}", frame.steps, step_size, values.size()));
    }
    for (std::size_t q = 0; q < quantities_.size(); ++q) {
      column_.clear();
      for (std::size_t step = 0; step < frame.steps; ++step) {
        for (std::size_t point = 0; point < points_; ++point) {
          const auto part =
              values.subspan(step * step_size + prefix_ + point * values_per_point_ + quantities_[q].first,
                             quantities_[q].components);
          column_.insert(column_.end(), part.begin(), part.end());
        }
      }
      datasets_[q].append(column_);
    }
    if (time_) {
      for (std::size_t step = 0; step < frame.steps; ++step) {
        time_->append(values.subspan(step * step_size, 1));
      }
    }
    frames_->append(std::array{static_cast<double>(frame.step), static_cast<double>(frame.steps),
                               static_cast<double>(frame.crc)});
  }

  void save(CheckpointWriter& checkpoint) const {
    for (const PackedRows& dataset : datasets_) {
      dataset.save(checkpoint);
    }
    if (time_) {
      time_->save(checkpoint);
    }
    frames_->save(checkpoint);
  }

  void take_over(const FileReader& before, const std::string& group, const CheckpointReader& checkpoint) {
    for (PackedRows& dataset : datasets_) {
      dataset.take_over(before, group, checkpoint);
    }
    if (time_) {
      time_->take_over(before, group, checkpoint);
    }
    frames_->take_over(before, group, checkpoint);
  }

  void write_kept() {
    for (PackedRows& dataset : datasets_) {
      dataset.write_kept();
    }
    if (time_) {
      time_->write_kept();
    }
    frames_->write_kept();
  }

private:
  std::span<const Quantity> quantities_;
  std::size_t points_ = 0;
  std::size_t prefix_ = 0;
  std::size_t values_per_point_ = 0;
  std::deque<PackedRows> datasets_;
  std::optional<PackedRows> time_;
  std::optional<PackedRows> frames_;
  std::vector<double> column_;
};

constexpr std::array<Quantity, 1> velocity_quantities{{{"velocity", "m/s", 0, 2}}};

std::vector<double> every_second(std::span<const double> values, std::size_t first) {
  std::vector<double> column;
  for (std::size_t i = first; i < values.size(); i += 2) {
    column.push_back(values[i]);
  }
  return column;
}

Table face_table(const ExchangeFaces& faces) {
  return {{{"x", "m", every_second(faces.position, 0)},
           {"y", "m", every_second(faces.position, 1)},
           {"normal_x", "1", every_second(faces.normal, 0)},
           {"normal_y", "1", every_second(faces.normal, 1)},
           {"impedance_p", "Pa s/m", every_second(faces.impedance, 0)},
           {"impedance_s", "Pa s/m", every_second(faces.impedance, 1)},
           {"static_traction_x", "Pa", every_second(faces.static_traction, 0)},
           {"static_traction_y", "Pa", every_second(faces.static_traction, 1)},
           {"source", "1", faces.source},
           {"field", "1", faces.field}}};
}

Table value_table(const std::vector<RecordedValue>& values) {
  std::vector<std::string> keys;
  std::vector<std::string> texts;
  for (const RecordedValue& value : values) {
    keys.push_back(value.key);
    texts.push_back(value.value);
  }
  return {{{"key", "1", keys}, {"value", "1", texts}}};
}

} // namespace

class ExchangeWriter::Implementation {
public:
  Implementation(const std::filesystem::path& path, const ExchangeDescription& description)
      : path_(path), file_(create_draft(path_)) {
    guarded([&] { describe(description); });
  }

  template <class Action>
  void guarded(Action action) {
    guard_(file_, action);
  }

  void describe(const ExchangeDescription& description) {
    create_status(root());
    write_attribute(root(), "content", std::string(exchange_content));
    write_attribute(root(), "schema_version", std::string(exchange_schema_version));
    write_attribute(root(), "session", description.session);
    write_attribute(root(), "mode", description.mode);
    write_attribute(root(), "start_time", description.start_time);
    write_attribute(root(), "end_time", description.end_time);
    write_text(root(), "case", description.case_text);
    link_table(root(), "case_values", value_table(description.case_values));
    const Handle sources = create_group(root(), "sources", description.sources.size());
    for (const ExchangeSource& source : description.sources) {
      add_source({sources.get(), path_}, source);
    }
    add_domain(description);
    publish_draft(file_, path_);
  }

  void link_table(Place place, const std::string& name, const Table& table) {
    const Handle group = write_unlinked_table(place, table);
    checked(H5Olink(group.get(), place.object, name.c_str(), H5P_DEFAULT, H5P_DEFAULT), path_, "add " + name);
  }

  void add_source(Place place, const ExchangeSource& source) {
    const Handle group = create_group(place, source.name, source.fields.size());
    const Place inside{group.get(), path_};
    write_attribute(inside, "number", source.number);
    write_attribute(inside, "serves", source.serves);
    std::vector<std::string> names;
    auto& tracks = sources_.emplace_back();
    for (const RecordedField& field : source.fields) {
      names.push_back(field.name);
      const Handle field_group = create_group(inside, field.name, field_quantities.size() + 2);
      const Place here{field_group.get(), path_};
      for (const auto& [name, value] : {std::pair<std::string_view, double>{"x_reference", field.x_reference},
                                        {"slowness_x", field.slowness_x},
                                        {"start_time", field.start_time},
                                        {"time_step", field.time_step}}) {
        write_attribute(here, name, value);
      }
      write_attribute(here, "declared_steps", static_cast<std::int64_t>(field.step_count));
      const hsize_t levels = field.levels.size();
      write_array(here, "levels", {&levels, 1}, std::span<const double>(field.levels), "m", false);
      tracks.emplace_back(here, field_quantities, "frames", field.levels.size(), 0);
    }
    write_attribute(inside, "fields", names);
  }

  void add_domain(const ExchangeDescription& description) {
    constexpr std::size_t links = 8;
    const Handle group = create_group(root(), domain_group, links);
    const Place inside{group.get(), path_};
    write_attribute(inside, "name", description.domain);
    write_attribute(inside, "number", description.domain_number);
    link_table(inside, "faces", face_table(description.faces));
    velocities_.emplace(inside, velocity_quantities, "velocity_frames", description.faces.count(), 1);
    if (description.mode == "lockstep") {
      tractions_.emplace(inside, traction_quantities, "traction_frames", description.faces.count(), 0);
    }
  }

  void flush() { flush_file(file_, path_); }

  void save(CheckpointWriter& checkpoint) {
    flush();
    sync_to_disk(path_);
    velocities_->save(checkpoint);
    if (tractions_) {
      tractions_->save(checkpoint);
    }
  }

  void take_over(const FileReader& before, const CheckpointReader& checkpoint) {
    velocities_->take_over(before, domain_group, checkpoint);
    if (tractions_) {
      tractions_->take_over(before, domain_group, checkpoint);
    }
    flush();
  }

  void close(std::string_view status) {
    for (auto& tracks : sources_) {
      for (Track& track : tracks) {
        track.write_kept();
      }
    }
    velocities_->write_kept();
    if (tractions_) {
      tractions_->write_kept();
    }
    // The values are safe on the disk before the status says so.
    flush();
    set_status(root(), status);
    flush();
  }

  Track& source(std::size_t number, std::size_t field) { return sources_.at(number).at(field); }
  Track& velocities() { return *velocities_; }
  Track& tractions() {
    if (!tractions_) {
      throw std::invalid_argument(fmt::format("{}: a run in mode window has no tractions", path_.string()));
    }
    return *tractions_;
  }

private:
  Place root() const { return {file_.get(), path_}; }

  std::filesystem::path path_;
  Handle file_;
  WriteGuard guard_;
  std::deque<std::deque<Track>> sources_;
  std::optional<Track> velocities_;
  std::optional<Track> tractions_;
};

ExchangeWriter::ExchangeWriter(const std::filesystem::path& file, const ExchangeDescription& description)
    : implementation_(std::make_unique<Implementation>(file, description)) {}
ExchangeWriter::~ExchangeWriter() = default;

void ExchangeWriter::source_frame(std::size_t source, std::size_t field, const RecordedFrame& frame,
                                  std::span<const double> values) {
  implementation_->guarded([&] { implementation_->source(source, field).append(frame, values); });
}

void ExchangeWriter::velocity_frame(const RecordedFrame& frame, std::span<const double> values) {
  implementation_->guarded([&] { implementation_->velocities().append(frame, values); });
}

void ExchangeWriter::traction_frame(const RecordedFrame& frame, std::span<const double> values) {
  implementation_->guarded([&] { implementation_->tractions().append(frame, values); });
}

void ExchangeWriter::flush() {
  implementation_->guarded([&] { implementation_->flush(); });
}

void ExchangeWriter::save(CheckpointWriter& checkpoint) {
  implementation_->guarded([&] { implementation_->save(checkpoint); });
}

void ExchangeWriter::take_over(const std::filesystem::path& before, const CheckpointReader& checkpoint) {
  const FileReader file(before, "recording");
  implementation_->guarded([&] { implementation_->take_over(file, checkpoint); });
}

void ExchangeWriter::close(std::string_view status) {
  implementation_->guarded([&] { implementation_->close(status); });
}

void mark_exchange(const std::filesystem::path& file, std::string_view status) {
  const Handle handle = open_for_writing(file);
  set_status({handle.get(), file}, status);
  flush_file(handle, file);
}

} // namespace tremolo::results
