#pragma once

#include <functional>

namespace tremolo::wavefield {

/// Incident particle velocity along the polarisation, SV (cos, -sin) and P (sin, cos) of the angle, at the
/// reference point.
struct Signal {
  std::function<double(double)> velocity; ///< m/s at time t (s); smooth, and zero outside [begin, end]
  double begin = 0.0;                     ///< s
  double end = 0.0;                       ///< s
  double highest_frequency = 0.0;         ///< Hz; above it the spectrum is negligible
};

/// Ricker velocity pulse V (1 - 2a) exp(-a), a = (pi f (t - t0))^2, cut where it has fallen below 1e-19 V.
/// @throws std::invalid_argument if the frequency is not positive or a value is not finite
Signal ricker(double frequency_hz, double time_s, double peak_velocity);

/// Largest velocity of the signal, m/s, at four times in its shortest period.
double peak_velocity(const Signal& signal);

/// @throws std::invalid_argument naming the quantity, its value and the allowed range
void validate(const Signal& signal);

} // namespace tremolo::wavefield
