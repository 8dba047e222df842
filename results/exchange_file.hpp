#pragma once

// The recorded exchange of a run, exchange.h5 (docs/recordings.md): what every source sent, the velocities
// that the domain gave back, in mode lockstep the tractions it was sent, each with the headers of its frames.
// A recording is complete only if its status says so.

#include "results/checkpoint_file.hpp"
#include "results/free_field_recording.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::results {

inline constexpr std::string_view exchange_schema_version = "1.0";

/// A source that takes part, and the fields it declares.
struct ExchangeSource {
  std::string name;
  std::int64_t number = 0;           ///< sender in its frames
  std::vector<std::string> serves;   ///< sides: "left", "right", "base"
  std::vector<RecordedField> fields; ///< step_count: as declared
};

/// The faces of the domain, in the order of the exchange; arrays of pairs are [faces * 2].
struct ExchangeFaces {
  std::vector<double> position;        ///< m
  std::vector<double> normal;          ///< outward, 1
  std::vector<double> impedance;       ///< P, S, Pa s/m
  std::vector<double> static_traction; ///< Pa
  std::vector<std::string> source;     ///< [faces] who serves the face
  std::vector<std::string> field;      ///< [faces] and by which field

  std::size_t count() const { return source.size(); }
};

/// A value that the recorded run's case had in force.
struct RecordedValue {
  std::string key; ///< "motion.angle_deg"
  std::string value;
  friend bool operator==(const RecordedValue&, const RecordedValue&) = default;
};

/// Facts known before the first frame.
struct ExchangeDescription {
  std::string session;
  std::string mode; ///< "window" or "lockstep"
  std::string case_text;
  std::vector<RecordedValue> case_values;
  std::vector<ExchangeSource> sources;
  std::string domain;
  std::int64_t domain_number = 0;
  ExchangeFaces faces;
  double start_time = 0.0; ///< of the exchange, s
  double end_time = 0.0;
};

/// The header of a frame, as far as it is not the same for all frames of its sender.
struct RecordedFrame {
  std::uint64_t step = 0; ///< first
  std::uint64_t steps = 0;
  std::uint32_t crc = 0; ///< CRC-32 of the frame
};

/// Writes a recording. Rows are kept until they fill a chunk of the file. After a failure the file is as the
/// last flush left it.
///
/// @throws std::runtime_error if the file cannot be written
class ExchangeWriter {
public:
  ExchangeWriter(const std::filesystem::path& file, const ExchangeDescription& description);
  ~ExchangeWriter();
  ExchangeWriter(const ExchangeWriter&) = delete;
  ExchangeWriter& operator=(const ExchangeWriter&) = delete;

  /// Steps of a field. @param values [steps, levels, recorded_values]
  void source_frame(std::size_t source, std::size_t field, const RecordedFrame& frame,
                    std::span<const double> values);
  /// @param values [steps, 1 + 2 faces]: the time (s), then vx, vy of each face
  void velocity_frame(const RecordedFrame& frame, std::span<const double> values);
  /// @param values [steps, 7 faces]: of each face the traction and the free field it took, vx, vy, sxx, syy,
  /// sxy
  void traction_frame(const RecordedFrame& frame, std::span<const double> values);

  void flush();

  /// Writes what a recording that goes on from here needs besides the file: what the domain sent and was
  /// sent. Sources send all their steps again.
  void save(CheckpointWriter& checkpoint);
  /// Goes on from there in a new file, before the first frame.
  /// @param before the file then, or as it was left later
  void take_over(const std::filesystem::path& before, const CheckpointReader& checkpoint);

  /// Writes what is kept, and the status: "complete", or "aborted at step K: REASON".
  void close(std::string_view status);

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Says in a recording that could not be closed why it is not complete; needs no room on the disk.
void mark_exchange(const std::filesystem::path& file, std::string_view status);

/// Reads a recording, complete or not. What its sources sent is read by FreeFieldRecording.
///
/// @throws std::runtime_error with file and reason where the file is absent, is no recording of an exchange,
/// has another major schema version, is damaged, or lacks what is asked for
class ExchangeReader {
public:
  explicit ExchangeReader(const std::filesystem::path& file);
  ~ExchangeReader();
  ExchangeReader(const ExchangeReader&) = delete;
  ExchangeReader& operator=(const ExchangeReader&) = delete;

  /// "complete", "running" (its writer was killed, or is at work) or "aborted at step K: REASON"
  std::string status() const;
  bool complete() const;
  const ExchangeDescription& description() const;
  /// The source that served a side.
  const ExchangeSource& source_of(std::string_view side) const;

  /// Frames of a source's field, or of "domain" and its field "velocity" or "traction", in their order.
  std::vector<RecordedFrame> frames(const std::string& participant, const std::string& field) const;

  /// Steps of the domain that are held.
  std::uint64_t domain_steps() const;
  /// @returns [1 + 2 faces]: the time (s), then vx, vy of each face
  std::vector<double> velocities(std::uint64_t step) const;
  /// @returns [2 faces]: the traction of each face; empty if the run was not in mode lockstep
  std::vector<double> tractions(std::uint64_t step) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace tremolo::results
