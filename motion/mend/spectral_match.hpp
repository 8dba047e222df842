#pragma once

// A record whose response spectrum is that of a target, by wavelets added in the time domain: Al Atik &
// Abrahamson (2010), Earthquake Spectra 26(3), 601-617. With t_i the time and s_i the sign of the largest
// displacement u_i of oscillator i, the wavelets f_j are added with amplitudes b_j that solve
//
//     sum_j c_ij b_j = s_i (S_i - |u_i(t_i)|),      c_ij = response of oscillator i to f_j at t_i,
//     f_j(t) = cos(w'_j (t - t_j + d_j)) exp(-((t - t_j + d_j)/g_j)^2),
//     w' = w sqrt(1 - D^2),   d = atan(sqrt(1 - D^2)/D)/w',   g = 1.178 f^-0.93 (s, Hz),
//
// until the spectrum is near. S_i is the target's spectral displacement. A wavelet has neither velocity nor
// displacement left at its end; where the ends of the record cut it, w (p + q t) is subtracted from all that
// is added, so that final velocity and displacement stay as they were, w = sin^2(pi t/T).

#include <span>
#include <vector>

namespace tremolo::motion {

/// Pseudo-spectral acceleration over rising periods, linear between them on logarithmic axes.
struct TargetSpectrum {
  std::vector<double> periods;      ///< s, at least two, rising
  std::vector<double> acceleration; ///< m/s2, positive
  double damping = 0.05;            ///< of critical, in [0.005, 0.5]

  /// @param period  s, inside of the table
  double at(double period) const;
};

struct SpectralMatch {
  std::vector<double> acceleration; ///< m/s2, as many samples as before
  double before = 0.0;              ///< largest misfit of the scaled record, |S_a/target - 1|
  double after = 0.0;               ///< largest misfit of the result
  int steps = 0;
};

struct MatchSettings {
  double tolerance = 0.05; ///< of the largest misfit, where the search ends
  int steps = 60;          ///< at most
};

/// Shortest period that a record with this step can be matched at, s.
double shortest_matched_period(double dt);

/// Scales a record to the target and matches it at 80 periods a decade. The best of all steps is returned,
/// whether or not it comes within the tolerance.
/// @param acceleration of the ground, m/s2
/// @throws std::invalid_argument for a target that is no spectrum, periods that the step does not resolve, or
/// that
///         are longer than half of the record
SpectralMatch spectrally_matched(std::span<const double> acceleration, double dt,
                                 const TargetSpectrum& target, const MatchSettings& settings = {});

} // namespace tremolo::motion
