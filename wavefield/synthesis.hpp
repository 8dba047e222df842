#pragma once

#include "wavefield/fourier.hpp"
#include "wavefield/half_space_field.hpp"
#include "wavefield/plane_waves.hpp"
#include "wavefield/signal.hpp"

#include <complex>
#include <cstddef>
#include <vector>

namespace tremolo::wavefield {

/// The periodic time window of the Fourier synthesis: samples start + j dt. Time i of the requested grid is
/// sample offset + i stride.
struct Window {
  double start = 0.0; ///< s
  double dt = 0.0;    ///< s
  std::size_t length = 0;
  std::size_t offset = 0;
  std::size_t stride = 1;
};

/// A window around the interval [begin, end] (s) with two-sided zero padding to `padding` times its length,
/// aligned with the grid and fine enough for a signal up to the highest frequency (Hz).
/// @throws std::invalid_argument if that needs more samples than fit in memory
Window make_window(const TimeGrid& grid, double begin, double end, double padding, double highest_frequency);

/// Fourier synthesis of histories from plane waves: what HalfSpaceField::sample does once it has chosen
/// window and waves.
class Synthesis {
public:
  using Spectrum = std::vector<std::complex<double>>;

  /// Spectra at one depth, without the delay along x. Frequency k is k / (length dt).
  struct DepthSpectra {
    Spectrum ux, uy, vx, vy, sxx, syy, sxy;
  };

  /// `one_sided` tells that the waves' coefficients jump to their conjugates across zero frequency, as
  /// post-critical ones do.
  /// @throws std::invalid_argument for a one-sided synthesis of a signal that leaves an offset of
  /// displacement
  Synthesis(const Signal& signal, const Window& window, std::vector<PlaneWave> waves, bool one_sided);

  /// At y below the surface (y <= 0, m), all waves ahead of the signal by `advance` (s).
  DepthSpectra at_depth(double y, double advance) const;

  /// Histories at `count` times of the grid where the field is `delay` (s) behind that of the spectra.
  History history(const DepthSpectra& spectra, double delay, std::size_t count);

private:
  /// factors_k spectrum_k to samples on the whole window, left in fourier_.samples().
  void to_time(const Spectrum& spectrum, const Spectrum& factors);
  std::vector<double> on_grid(std::size_t count);
  std::vector<double> displacement(const Spectrum& spectrum, const Spectrum& shift, double mean_velocity,
                                   std::size_t count);
  double omega(std::size_t bin) const;

  Window window_;
  std::vector<PlaneWave> waves_;
  bool one_sided_;
  RealFourier fourier_;
  Spectrum velocity_;     ///< of the signal, m/s, up to the last bin that matters
  Spectrum displacement_; ///< of its integral, m
};

} // namespace tremolo::wavefield
