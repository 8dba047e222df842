#pragma once

// Pulses with closed forms. With tau = t - time and A the amplitude in the record's unit:
//
//   ricker        A (1 - 2 a) exp(-a),  a = (pi f tau)^2                                      (Ricker 1943)
//   ormsby        A (R(f4, f3) - R(f2, f1)) / same at tau = 0,
//                 R(p, q) = (p^2 sinc^2(p tau) - q^2 sinc^2(q tau)) pi/(p - q): a trapezoid of amplitude in
//                 frequency, flat from f2 to f3, zero outside f1 to f4                        (Ormsby 1961)
//   harmonic      A sin(2 pi f tau) for `cycles` whole cycles from t = time
//   tapered_sine  the harmonic under half cosines over its first and last `ramp_cycles` cycles
//   centrifuge    the pseudo-harmonic motion of shakers in a centrifuge: a sine of `cycles` cycles under
//                 straight ramps over its first and last `ramp_cycles`, plus its third harmonic with the part
//                 `third_harmonic` of the amplitude, which servo-hydraulic actuators leave

#include "motion/record.hpp"

#include <array>
#include <cstddef>

namespace tremolo::motion {

enum class PulseShape { ricker, ormsby, harmonic, tapered_sine, centrifuge };

struct Pulse {
  PulseShape shape = PulseShape::ricker;
  double amplitude = 1.0;          ///< in the record's unit
  double time = 0.0;               ///< of the peak (ricker, ormsby) or of the start, s
  double frequency = 1.0;          ///< Hz; not of ormsby
  std::array<double, 4> corners{}; ///< ormsby: f1 < f2 < f3 < f4, Hz, f1 >= 0
  double cycles = 1.0;             ///< of the sines
  double ramp_cycles = 0.0;        ///< at each end; at most half the cycles
  double third_harmonic = 0.0;     ///< part of the amplitude
};

/// @throws std::invalid_argument for parameters out of range
void require_sound(const Pulse& pulse);

double value(const Pulse& pulse, double t);

/// Samples 0, dt, ..., (count - 1) dt.
Record sampled(const Pulse& pulse, Unit unit, double dt, std::size_t count);

} // namespace tremolo::motion
