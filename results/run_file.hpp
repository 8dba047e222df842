#pragma once

// The result file of a run: `run.h5` (HDF5, schema in docs/output-format.md) and its sibling `run.xdmf` for
// ParaView.
//
//     RunWriter run("out/run.h5", {.title = ..., .case_text = ..., .plan = ...});
//     TimeSeries& toe = run.add_series("/monitors/toe", {"time", "x", ...}, {"s", "m", ...});
//     while (...) { toe.append(row);  run.write_frame(time, fields); }
//     run.table("/timings", timings);
//     run.finish();
//
// A process that dies at any moment leaves a file that opens and holds everything up to the last flush
// (docs/output-format.md, "After a crash"). One thread at a time may use a writer; there is no global state.

#include "results/run_checksums.hpp"
#include "results/run_data.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tremolo::results {

/// Version of the layout of `run.h5`: "major.minor"; a reader refuses another major.
inline constexpr std::string_view schema_version = "1.10";

/// Facts about a run that are known before its first step.
struct RunDescription {
  std::string title;
  std::string case_text;     ///< the case file as read, /case
  std::string plan;          ///< the plan of effects, /plan
  std::string build_version; ///< of tremolo
  std::string compiler;
  std::string build_flags;
  /// The kind of a file without particles, e.g. "column", stored as an attribute of the root. Such a file
  /// holds no frames and has no XDMF file.
  std::string content = {};
};

/// A growing table of numbers: one row a time, first column the time in s.
class TimeSeries {
public:
  /// Adds one row; it reaches the file at the writer's next flush.
  /// @throws std::invalid_argument where the row has not one value a column
  void append(std::span<const double> row);

private:
  friend class RunWriter;
  TimeSeries(Checksum of_none, std::size_t columns) : checksum_(std::move(of_none)), columns_(columns) {}

  Checksum checksum_;
  std::size_t columns_;
  std::vector<double> pending_; ///< rows that wait for the flush
};

/// Creates a run file and fills it.
///
/// Every member that writes throws std::runtime_error with the file and the reason (full disk, no permission
/// ...) when it cannot, and std::invalid_argument when what it is given contradicts itself (array lengths,
/// names used twice).
class RunWriter {
public:
  /// Creates `file` (replacing an older run) with status "running".
  RunWriter(const std::filesystem::path& file, const RunDescription& description);
  /// Closes the file. A run that was neither finished nor aborted keeps the status "running".
  ~RunWriter();
  RunWriter(const RunWriter&) = delete;
  RunWriter& operator=(const RunWriter&) = delete;

  /// Sets an attribute of the file's root, e.g. mesh_size. Before the first frame.
  void attribute(std::string_view name, const AttributeValue& value);

  /// Adds a series, e.g. "/monitors/toe" or "/energy", and the group that it stands in. The reference stays
  /// valid as long as the writer. Before the first frame.
  /// @param attributes  besides `columns` and `units`
  TimeSeries& add_series(std::string_view path, std::span<const std::string> columns,
                         std::span<const std::string> units, std::span<const Attribute> attributes = {});

  /// Declares the boundary faces of /boundary. Once, before the first frame.
  void set_boundary(const BoundaryFaces& faces);

  /// Adds one time of the boundary exchange; it reaches the file at the next flush.
  void append_boundary(double time, const BoundarySample& exchange);

  /// Writes the particles at `time` (s) as /frames/NNNN, flushes the file and then renews the XDMF. The
  /// number of particles may differ from frame to frame. `fields` must hold "position" with 2 components.
  /// @param parts  what the run has beside soil, which may be no points, written as /GROUP/NNNN
  void write_frame(double time, std::span<const Field> fields, std::span<const FramePart> parts = {});

  /// Writes such a frame from values that are made meanwhile: the file and the checksums are those of a frame
  /// whose values are all there.
  void write_frame(double time, std::size_t particles, std::vector<StreamedField> fields,
                   std::span<const FramePart> parts = {});

  /// Makes everything written so far durable against the end of this process.
  void flush();

  /// Flushes if the buffered rows hold more than a mebibyte. It is called after the rows of each time, so
  /// that memory does not grow with the time between two frames.
  void flush_if_large();

  /// Flushes and waits for the disk, so that a crash of the machine loses nothing.
  void sync();

  /// Writes a table of named columns, e.g. /timings.
  void table(std::string_view path, const Table& table);

  /// Status "complete", flushed and closed; then ParaView's view of the frames is added
  /// (results/paraview/vtkhdf.hpp).
  /// @return why that view could not be added, in a sentence; nothing if it was
  std::optional<std::string> finish();

  /// Status "aborted: reason", flushed and closed.
  void abort(std::string_view reason);

  std::size_t frame_count() const;

  /// Checksums of all rows and frames so far, including buffered ones.
  std::vector<Checksum> checksums() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Adds a table to the closed run file of an ended process, e.g. the launcher's /processes.
/// @throws std::runtime_error where the file cannot be written or holds the table already
void append_table(const std::filesystem::path& file, std::string_view path, const Table& table);

/// Replaces the status of a closed run file whose process ended without saying how: "aborted: reason".
/// @throws std::runtime_error where the file cannot be written
void mark_aborted(const std::filesystem::path& file, std::string_view reason);

/// A table and where it belongs in a file.
struct NamedTable {
  std::string path; ///< e.g. "/histories/toe"
  Table table;
};

/// Creates an HDF5 file of tables, e.g. verify.h5.
/// @param content  what they are, e.g. "verification": an attribute of the root
/// @throws std::runtime_error where the file cannot be written
void write_tables(const std::filesystem::path& file, std::string_view content,
                  std::span<const NamedTable> tables);

/// The attribute `content` of a file, which says what it is; empty where it has none or is no HDF5 file.
std::string content_of(const std::filesystem::path& file);

/// Reads a run file, complete or not.
///
/// @throws std::runtime_error with file and reason where the file is absent, is no run file, has another
/// major schema version, or lacks what is asked for.
class RunReader {
public:
  explicit RunReader(const std::filesystem::path& file);
  ~RunReader();
  RunReader(const RunReader&) = delete;
  RunReader& operator=(const RunReader&) = delete;

  std::string title() const;
  std::string status() const; ///< "running", "complete" or "aborted: reason"
  std::string case_text() const;
  std::string plan() const;

  bool has_attribute(std::string_view name) const;
  AttributeValue attribute(std::string_view name) const;

  /// Times (s) of the frames, in order.
  const std::vector<double>& frame_times() const;
  /// Names of the fields of a frame.
  std::vector<std::string> frame_fields(std::size_t frame) const;
  /// One field of one frame; integers are returned as doubles.
  FieldData frame_field(std::size_t frame, std::string_view name) const;
  /// A field of a frame without its values, and these in pieces of whole particles.
  FieldShape frame_field_shape(std::size_t frame, std::string_view name) const;
  void frame_field_in_pieces(std::size_t frame, std::string_view name,
                             const std::function<void(FieldValues piece)>& take) const;
  /// Names of the fields of a part of a frame; none in a run without such parts.
  /// @param group  one of frame_parts
  std::vector<std::string> part_fields(std::string_view group, std::size_t frame) const;
  /// One field of a part of a frame.
  FieldData part_field(std::string_view group, std::size_t frame, std::string_view name) const;

  /// Names of the monitors, in alphabetical order.
  std::vector<std::string> monitors() const;
  /// A series by its path, e.g. "/monitors/toe".
  SeriesData series(std::string_view path) const;
  BoundaryHistory boundary() const;

  bool has_table(std::string_view path) const;
  Table table(std::string_view path) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace tremolo::results
