#pragma once

// The report of `tremolo motion`: a motion's measures as text, its histories and spectra as tables.

#include "motion/mend/spectral_match.hpp"
#include "motion/record.hpp"

#include <filesystem>
#include <string>

namespace tremolo::app {

/// First lines of the tables.
inline constexpr const char* response_heading = "period,displacement,velocity,acceleration\n";
inline constexpr const char* fourier_heading = "frequency,amplitude\n";

/// Quantity, unit, step and kind, then a measure a line.
std::string motion_report(const motion::Record& record, const std::string& name);

/// The warning that belongs to it, empty where the motion ends at rest.
std::string motion_warning(const motion::Record& record);

/// A warning if `--unit` overrides the unit that the file names; empty if they agree.
std::string unit_warning(const motion::Record& record);

/// Columns t (s), a (m/s2), v (m/s), d (m). Every table @throws std::runtime_error where it cannot be
/// written.
void write_histories(const motion::Record& record, const std::filesystem::path& file);

/// period (s), displacement (m), pseudo-velocity (m/s) and pseudo-acceleration (m/s2) at PEER's periods from
/// 0.01 to 10 s and at 200 even on a logarithmic axis.
void write_response_spectrum(const motion::Record& record, double damping, const std::filesystem::path& file);

/// period (s), acceleration (m/s2).
void write_target_spectrum(const motion::TargetSpectrum& target, const std::filesystem::path& file);

/// frequency (Hz), amplitude (m/s) of the acceleration.
void write_fourier_spectrum(const motion::Record& record, const std::filesystem::path& file);

/// histories.csv, response.csv and fourier.csv in a folder, which is made.
void write_tables(const motion::Record& record, double damping, const std::filesystem::path& folder);

} // namespace tremolo::app
