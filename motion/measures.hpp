#pragma once

#include "motion/record.hpp"

#include <optional>
#include <span>
#include <string>

namespace tremolo::motion {

/// Intensity measures of a strong motion, SI units.
struct Measures {
  double pga = 0.0;                  ///< max |a|, m/s2
  double pgv = 0.0;                  ///< max |v|, m/s
  double pgd = 0.0;                  ///< max |d|, m
  double arias = 0.0;                ///< pi/(2 g) int a^2 dt, m/s
  double significant_duration = 0.0; ///< between 5 and 95 % of the Arias intensity, s
  double duration_5_75 = 0.0;        ///< between 5 and 75 % of it, s
  double cav = 0.0;                  ///< cumulative absolute velocity int |a| dt, m/s
  double mean_period = 0.0;       ///< sum C_i^2/f_i / sum C_i^2 of Fourier amplitudes C_i, 0.25 to 20 Hz, s
  double residual_velocity = 0.0; ///< at the last sample, m/s
  double residual_displacement = 0.0; ///< m
};

/// Measures of a record of any quantity; the others follow by integration or differentiation (with_unit).
Measures measures(const Record& record);

/// Velocity and displacement are the trapezoidal integrals from rest.
/// @param acceleration m/s2
/// @throws std::invalid_argument for fewer than two samples or dt <= 0
Measures measures(std::span<const double> acceleration, double dt);

/// A residual velocity of more than this part of the PGV is worth a warning.
inline constexpr double tolerated_residual = 0.01;

/// "residual velocity 0.012 m/s, 4.1 % of PGV: ..." where the motion does not end at rest.
std::optional<std::string> residual_warning(const Measures& measures);

} // namespace tremolo::motion
