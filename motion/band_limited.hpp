#pragma once

// A record as a function of time: the band-limited one through its samples, with zeros before and after.
//
// On a window of L samples (zeros included) at steps of dt, with X_k their discrete Fourier transform and
// w_k = 2 pi k / (L dt),
//
//     x(t) = 1/L Re( X_0 + 2 sum_{0 < k < L/2} X_k exp(i w_k t) + X_{L/2} exp(i w_{L/2} t) ):
//
// its spectrum is the record's up to the Nyquist frequency and nothing above, which is what a site response
// in the frequency domain takes a record for. Slope and integral follow term by term, X_k i w_k and X_k / (i
// w_k); the mean X_0/L, which no periodic function integrates, gives the ramp t X_0/L.

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::motion {

/// Integral over time from long before the first sample, at the samples and at further steps of dt around
/// them.
/// @param before, after  how many steps before the first sample and after the last one
std::vector<double> band_limited_integral(std::span<const double> samples, double dt, std::size_t before,
                                          std::size_t after);

/// Slope at the samples of a record that begins and ends near zero.
std::vector<double> band_limited_slope(std::span<const double> samples, double dt);

/// Values and slopes at finer steps.
struct Refined {
  double dt = 0.0; ///< s
  std::vector<double> value;
  std::vector<double> slope; ///< per s
};

/// The record, which begins and ends near zero, from its first sample to its last one at steps of dt /
/// factor.
Refined refined(std::span<const double> samples, double dt, std::size_t factor);

} // namespace tremolo::motion
