#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::motion {

/// Largest response of one oscillator.
struct Response {
  double period = 0.0;       ///< s
  double displacement = 0.0; ///< max |u| relative to the ground, m
  double velocity = 0.0;     ///< pseudo-velocity w max |u|, m/s
  double acceleration = 0.0; ///< pseudo-acceleration w^2 max |u|, m/s2
};

/// Displacement relative to the ground of an oscillator at rest at the first sample, exact for an
/// acceleration that is linear between its samples (Nigam & Jennings 1969).
/// @param acceleration of the ground, m/s2   @param damping of critical, in [0, 1)
std::vector<double> oscillator(std::span<const double> acceleration, double dt, double period,
                               double damping);

/// The peak is sought at the samples: resample a record coarser than a tenth of the shortest period.
std::vector<Response> response_spectrum(std::span<const double> acceleration, double dt,
                                        std::span<const double> periods, double damping);

/// `count` periods from `first` to `last` s, evenly spaced on a logarithmic axis.
std::vector<double> spaced_periods(double first, double last, std::size_t count);

/// The 105 periods from 0.01 to 10 s at which PEER tabulates response spectra, s: the columns T0.010S to
/// T10.000S of the NGA-West2 flatfile (Ancheta et al. 2013, PEER NGA-West2 Database, PEER 2013/03).
std::span<const double> customary_periods();

/// The customary periods from `first` to `last` s together with `count` that are evenly spaced on a
/// logarithmic axis, rising.
std::vector<double> tabulated_periods(double first, double last, std::size_t count);

struct FourierAmplitude {
  double frequency = 0.0; ///< Hz
  double amplitude = 0.0; ///< |int a exp(-i w t) dt|, in the unit of the samples times s
};

/// The spectrum from 0 to the Nyquist frequency; the samples are padded with zeros to the next length of
/// which 2, 3 and 5 are the only factors.
std::vector<FourierAmplitude> fourier_spectrum(std::span<const double> samples, double dt);

} // namespace tremolo::motion
