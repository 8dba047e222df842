#pragma once

#include "wavefield/layers/layered_half_space.hpp"

#include <complex>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace tremolo::wavefield {

/// A motion recorded at the surface of the layers or within them: the horizontal component for SV, the
/// vertical one for P, at x = 0, samples at 0, dt, 2 dt, ... of any kind (acceleration, velocity,
/// displacement).
struct RecordedMotion {
  std::span<const double> samples;
  double dt = 0.0;    ///< s
  double depth = 0.0; ///< below the surface, at most the thickness of the layers, m
  /// Hz; the record is taken up to it whole and not at all from band_end times it on.
  double cutoff = std::numeric_limits<double>::infinity();
};

/// Frequency above which nothing of a record is left, over its cutoff.
inline constexpr double band_end = 1.25;

/// The share of a frequency (Hz) of a record that is kept: 1 up to the cutoff, 1/2 at 1.125 times it, 0 from
/// band_end times it on.
double band_weight(double frequency, double cutoff);

/// The record without what lies above its cutoff: zero phase, at the record's times.
std::vector<double> band_limited(const RecordedMotion& record);

/// The incident wave of a record, frequency by frequency.
struct IncidentSpectrum {
  /// The bins hold the incident motion, for RealFourier::inverse() on the window.
  std::vector<std::complex<double>> bins;
  /// |incident / recorded| of the ground at each bin up to the end of the record's band, the weight left out;
  /// that at zero frequency is the one at the lowest frequency.
  std::vector<double> amplification;
};

/// Incident motion along the polarisation at the top of the half-space under which the ground moves as
/// recorded, on a periodic window of so many samples, of which those beyond the record are zero.
/// @throws std::invalid_argument for values outside their range, and where the ground damps the record's
///         highest frequencies to nothing
IncidentSpectrum incident_spectrum(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                   const RecordedMotion& record, std::size_t window);

/// @throws std::invalid_argument naming the quantity, its value and the allowed range
void validate(const RecordedMotion& record, const LayeredHalfSpace& profile);

} // namespace tremolo::wavefield
