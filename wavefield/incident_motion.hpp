#pragma once

#include "wavefield/layers/layered_half_space.hpp"
#include "wavefield/layers/recorded_motion.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::wavefield {

// Recorded motions as incident waves. A motion is the horizontal component for SV and the vertical one for P,
// at the top of the half-space, x = 0, of any kind (acceleration, velocity, displacement: the answer is the
// same kind), samples at 0, dt, 2 dt, ...

/// Outcrop over incident motion, a real factor: of the surface of the half-space alone, undamped; 2 at
/// vertical incidence.
/// @throws std::invalid_argument beyond the critical angle, where the factor is complex, and where the
///         outcrop hardly moves in that component
double outcrop_factor(const LayeredHalfSpace& profile, WaveType wave, double angle_rad);

/// Incident motion along the polarisation whose wave moves the outcrop as given: outcrop / outcrop_factor.
std::vector<double> incident_from_outcrop(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                          std::span<const double> outcrop);

/// An incident motion, and what dividing by a transfer function does to the noise of a record.
struct Deconvolution {
  std::vector<double> incident;       ///< longer than the record
  std::size_t lead = 0;               ///< samples of it before the record's first one
  double largest_amplification = 0.0; ///< of any frequency of the record: largest |incident / recorded|
  double at_hz = 0.0;                 ///< the frequency where it is
};

/// Incident motion along the polarisation whose wave moves the top of the half-space, under the profile, as
/// given, and not at all before and after: spectral division by the within transfer function. To hold the
/// base still while the layers ring, the incident wave goes on after the record; with damping models that are
/// not causal it also begins before it. It is returned from where it rises above to where it falls below
/// 1e-9 of its peak, and is exact to 1e-7 of it: the window is doubled until that changes less.
/// @param largest_amplification  that is allowed at any frequency up to 1/(2 dt)
/// @throws std::invalid_argument for layers without damping, whose within motion vanishes at the frequencies
///         at which they resonate on a rigid base, and where noise would be amplified more than is allowed
/// @throws std::runtime_error    if the layers ring longer than the largest window
Deconvolution incident_from_within(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                   std::span<const double> within, double dt,
                                   double largest_amplification = 100.0);

/// The outcrop over the recorded motion that incident_from_record() allows at any frequency.
inline constexpr double largest_outcrop_over_record = 10.0;

/// Incident motion along the polarisation under which the ground moves as recorded at a depth, and not at all
/// before and after: spectral division up to the record's cutoff (recorded_motion.cpp has the formula). It
/// begins before the record, by the time that the wave takes up to the recorder and the cutoff's filter
/// rings, and goes on after it; it is returned from where it rises above to where it falls below 1e-6 of its
/// peak, and is exact to 1e-7 of that: the window is doubled until that changes less.
/// @throws std::invalid_argument for values outside their range; beyond the critical angle; for a record
///         within layers without damping, whose motion vanishes at the frequencies at which those above
///         resonate; and where a frequency would be amplified more than largest_outcrop_over_record, with the
///         cutoff that would do
/// @throws std::runtime_error    if the layers ring longer than the largest window
Deconvolution incident_from_record(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                   const RecordedMotion& record);

} // namespace tremolo::wavefield
