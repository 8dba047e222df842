#pragma once

// The incident motion as a smooth function of time.
//
// Ricker: v(t) = V (1 - 2a) exp(-a), a = (pi f (t - t0))^2.
//
// Record: the band-limited function through its samples (motion/band_limited.hpp), which has the record's
// discrete Fourier spectrum up to its Nyquist frequency and nothing above. Accelerations are integrated as
// that function; velocities are first multiplied by a half cosine that rises from 0 to 1 over the first 0.1
// s. After the last sample a half cosine takes the velocity to 0 within 1 s. A band-limited function that is
// not zero at its first sample is not zero just before it either: there a half cosine takes the velocity to 0
// within 16 steps.
//
// Several shakings: v(t) = sum of v_i(t - t_i), each motion from the start t_i of its stage on.

#include "scene/case.hpp"

#include <memory>
#include <span>
#include <vector>

namespace tremolo::scene {

/// Particle velocity of the incident wave alone, along its polarisation, at the reference point. Cheap to
/// copy; may be evaluated from several threads.
class Motion {
public:
  static Motion ricker(const RickerPulse& pulse);

  /// A record of velocities (m/s) or accelerations (m/s2) at 0, dt, 2 dt, ... (s).
  /// @throws std::invalid_argument for fewer than two samples, dt <= 0, or values that are not finite
  static Motion of_velocity(std::span<const double> velocity, double dt);
  static Motion of_acceleration(std::span<const double> acceleration, double dt);

  /// A motion that begins later, by a time in s, and the sum of at least one.
  Motion after(double time) const;
  static Motion sum(std::vector<Motion> motions);

  /// m/s at time t (s); zero outside [begin(), end()].
  double velocity(double t) const;

  /// Support, s.
  double begin() const { return begin_; }
  double end() const { return end_; }

  /// Hz; above it the spectrum is negligible: 6.5 f of a Ricker pulse (1e-16 of its peak), 1/dt of a record
  /// (twice its Nyquist frequency, so that what samples by this frequency keeps the record's own ones).
  double highest_frequency() const { return highest_frequency_; }

private:
  class Shape;
  class Ricker;
  class Samples;
  class Later;
  class Sum;
  /// The band-limited function through velocities from `start` on.
  static Motion through(double start, std::span<const double> velocity, double dt);
  Motion(std::shared_ptr<const Shape> shape, double begin, double end, double highest_frequency);

  std::shared_ptr<const Shape> shape_;
  double begin_ = 0.0;
  double end_ = 0.0;
  double highest_frequency_ = 0.0;
};

/// A motion at equal times that hold all its frequencies, with a margin for its peaks.
struct SampledMotion {
  double begin = 0.0;           ///< s
  double dt = 0.0;              ///< s
  std::vector<double> velocity; ///< m/s

  double time(std::size_t i) const { return begin + static_cast<double>(i) * dt; }
};

SampledMotion sampled(const Motion& motion);

/// The motion of one shaking, and that of a plane wave in all of them; reads the records.
/// @throws motion::RecordError (motion/record.hpp) for a record that cannot be read
Motion motion(const ShakingMotion& shaking);
Motion motion(const MotionInput& input);

/// The highest frequency of all plane waves, Hz.
double highest_frequency(const Case& scene);

} // namespace tremolo::scene
