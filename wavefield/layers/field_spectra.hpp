#pragma once

#include "wavefield/layers/reflectivity.hpp"
#include "wavefield/signal/fourier.hpp"
#include "wavefield/signal/history.hpp"
#include "wavefield/signal/signal.hpp"
#include "wavefield/signal/window.hpp"

#include <complex>
#include <map>
#include <span>
#include <vector>

namespace tremolo::wavefield {

using Spectrum = std::vector<std::complex<double>>;

/// An incident wave under layers: everything but where and when.
struct FieldSetup {
  LayeredHalfSpace profile;
  Incidence incidence;
  double surface_level = 0.0; ///< m
  Signal signal;
  Part part = Part::total;

  double top_of(std::size_t medium) const; ///< y of the top of layer or half-space, m

  /// Index of the medium at a point, from the top.
  std::size_t medium_at(const Point& point) const;

  /// Whether the spectra jump to their conjugates across zero frequency, so that the field has algebraic
  /// tails and no first arrival: beyond the critical angle, and with damping that jumps at
  /// zero frequency (hysteretic, shake).
  bool has_kink() const;
};

/// Spectrum of the incident velocity on a window, up to the last bin that matters.
struct SignalSpectrum {
  Window window;
  Spectrum velocity;          ///< m/s
  double offset = 0.0;        ///< displacement that the signal leaves, m
  double absolute_area = 0.0; ///< integral of |velocity|, m
};

/// @throws std::invalid_argument for a signal that is not finite
SignalSpectrum signal_spectrum(const Signal& signal, const Window& window, RealFourier& fourier);

/// Spectra at one depth without the delay along x; those of quantities that were not asked for are empty.
/// Displacement is velocity / s, exx is -p vx.
struct DepthSpectra {
  Spectrum vx, vy;
  Spectrum sxx, syy, sxy;
  Spectrum eyy, gxy;
};

/// Spectra of the field in some of the media.
class FieldSpectra {
public:
  /// @param media  indices in which spectra will be asked for
  FieldSpectra(const FieldSetup& setup, const SignalSpectrum& signal, std::span<const std::size_t> media);

  /// Spectra at level y (m) in a medium; velocity always, stress and strain on request. Overwrites `spectra`.
  void at(double y, std::size_t medium, const Quantities& quantities, DepthSpectra& spectra) const;

  double slowness_x() const { return reflectivity_.slowness_x(); }

  /// Velocity per incident velocity at the lowest frequencies, the same at all depths: components x and y.
  std::array<std::complex<double>, 2> static_response() const { return static_; }

private:
  /// Waves of one medium times the signal's spectrum, one entry a bin; `bases` and `moduli` have one entry
  /// for all bins where they do not depend on frequency.
  struct MediumWaves {
    double top = 0.0, bottom = 0.0; ///< levels that amplitudes are referred to, m
    std::vector<WaveBasis> bases;
    std::vector<ComplexModuli> moduli;
    std::array<Spectrum, 2> up, down; ///< P, SV
    Spectrum carried;                 ///< velocity besides the waves; empty but under Rayleigh damping
  };

  void fill(MediumWaves& waves, std::size_t medium, const LayerAmplitudes& amplitudes,
            std::complex<double> incident, std::size_t bin) const;

  Window window_;
  Part part_;
  WaveType wave_;
  Reflectivity reflectivity_;
  std::map<std::size_t, MediumWaves> media_;
  std::array<std::complex<double>, 2> static_;
};

} // namespace tremolo::wavefield
