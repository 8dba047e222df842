#pragma once

// A recording of a free field: its motion at some levels of one vertical line, step by step, in an HDF5 file
// that any program can write (docs/free-fields/exchange.md) and that is read back bit for bit.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::results {

inline constexpr std::string_view recording_schema_version = "1.0";

/// Values per level and step: vx, vy (m/s), sxx, syy, sxy (Pa, dynamic part, tension positive), then the time
/// derivatives of these five (m/s2, Pa/s).
inline constexpr std::size_t recorded_values = 10;

/// One field of a recording, without its motion.
struct RecordedField {
  std::string name;           ///< "total" or "incident"; of a plane wave that adds to it "total+vertical"
  std::vector<double> levels; ///< m, ascending; an interface stands twice, from below and from above
  double x_reference = 0.0;   ///< x of the line, m
  double slowness_x = 0.0;    ///< at another x the motion is later by slowness_x (x - x_reference), s/m
  double start_time = 0.0;    ///< of step 0, s
  double time_step = 0.0;     ///< s
  std::uint64_t step_count = 0;
};

/// A field and its motion.
struct FieldToRecord {
  RecordedField field;
  std::span<const double> values; ///< [step_count, levels, recorded_values]
};

/// Writes a recording.
/// @param title what it is, for people
/// @param profile the ground it belongs to, for people: layers, their stiffness and damping
/// @throws std::invalid_argument for a field without levels or with another number of values than its shape
/// asks for; std::runtime_error if the file cannot be written
void write_free_field_recording(const std::filesystem::path& file, const std::string& title,
                                const std::string& profile, std::span<const FieldToRecord> fields);

/// A recording that is open for reading.
class FreeFieldRecording {
public:
  /// @throws std::runtime_error for a file that is no recording, naming what is missing or has another shape
  explicit FreeFieldRecording(const std::filesystem::path& file);
  /// Opens the part of a recorded exchange (exchange_file.hpp) that a source sent, as far as it was stored.
  FreeFieldRecording(const std::filesystem::path& exchange, const std::string& source);
  ~FreeFieldRecording();
  FreeFieldRecording(const FreeFieldRecording&) = delete;
  FreeFieldRecording& operator=(const FreeFieldRecording&) = delete;

  const std::vector<RecordedField>& fields() const;

  /// One step of a field.
  /// @param values out: [levels, recorded_values]
  void read(std::size_t field, std::uint64_t step, std::span<double> values) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace tremolo::results
