#pragma once

#include "wavefield/layers/layered_half_space.hpp"

#include <complex>
#include <span>
#include <vector>

namespace tremolo::wavefield {

/// Complex amplitude of the displacement, time kernel exp(+i omega t), on the vertical line x = 0.
struct Amplitude {
  std::complex<double> ux, uy;
};

/// Displacement at the depths (m below the surface, >= 0) per unit displacement of the incident wave, along
/// its polarisation, at the top of the half-space. One row a frequency (Hz, > 0), one entry a depth.
/// @throws std::invalid_argument for values outside their range
std::vector<std::vector<Amplitude>> transfer(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                             std::span<const double> frequencies_hz,
                                             std::span<const double> depths);

/// Motion of the surface of the half-space alone, without layers and damping, under a unit incident wave:
/// the outcrop. Real below the critical angle; (2, 0) for vertical SV, (0, 2) for vertical P.
Amplitude outcrop(const HalfSpace& half_space, WaveType wave, double angle_rad);

/// The surface of the profile at one frequency.
struct SurfaceTransfer {
  double frequency_hz = 0.0;
  Amplitude surface;               ///< per unit incident displacement at the top of the half-space
  Amplitude within;                ///< motion of the top of the half-space under the profile, per the same
  std::complex<double> to_outcrop; ///< surface over outcrop motion: horizontal for SV, vertical for P
  std::complex<double> to_within;  ///< surface over within motion, same component
};

std::vector<SurfaceTransfer> surface_transfer(const LayeredHalfSpace& profile, WaveType wave,
                                              double angle_rad, std::span<const double> frequencies_hz);

} // namespace tremolo::wavefield
