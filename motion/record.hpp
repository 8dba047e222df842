#pragma once

// Records in PEER text format: header lines, one of them with NPTS and DT ("NPTS= 2000, DT= .0200 SEC" or
// "4096 0.0100 NPTS, DT", in any spelling), then the samples, in fixed or free columns. AT2 holds
// accelerations in g, VT2 velocities in cm/s.

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::motion {

/// Standard gravity, the g of PEER records, m/s2.
inline constexpr double standard_gravity = 9.80665;

/// Samples at 0, dt, 2 dt, ...
struct Record {
  double dt = 0.0;             ///< s
  std::vector<double> samples; ///< in the unit of the file
};

/// What is wrong with a record, as "file:line: text".
class RecordError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// @throws RecordError if the file cannot be read, has no NPTS and DT, holds something that is not a number,
/// or another
///         number of samples than it says
Record read_record(const std::filesystem::path& file);

/// The same from text; `file` names it in messages.
Record parse_record(const std::string& text, const std::filesystem::path& file);

/// Time integral by the trapezoidal rule, zero at the first sample.
std::vector<double> integrate(std::span<const double> samples, double dt);

/// Intensity measures of a strong motion.
struct RecordMeasures {
  double pga = 0.0;                  ///< max |a|, m/s2
  double pgv = 0.0;                  ///< max |v|, m/s
  double arias = 0.0;                ///< pi/(2 g) int a^2 dt, m/s
  double significant_duration = 0.0; ///< between 5 and 95 % of the Arias intensity, s
  double mean_period = 0.0; ///< sum C_i^2/f_i / sum C_i^2 over Fourier amplitudes C_i, 0.25 to 20 Hz (Rathje
                            ///< et al. 1998), s
};

/// @param acceleration m/s2
/// @throws std::invalid_argument for fewer than two samples or dt <= 0
RecordMeasures measures(std::span<const double> acceleration, double dt);

} // namespace tremolo::motion
