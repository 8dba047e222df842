#pragma once

#include "wavefield/layers/field_spectra.hpp"
#include "wavefield/signal/fourier.hpp"
#include "wavefield/signal/history.hpp"
#include "wavefield/signal/window.hpp"

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::wavefield {

/// Fourier synthesis of histories on one window: what LayeredField::sample does once it has chosen the
/// window.
class Synthesis {
public:
  /// @throws std::invalid_argument for a signal that is not finite
  Synthesis(const FieldSetup& setup, const Window& window);

  /// Histories at the points, `count` times of the grid that the window is aligned with.
  /// @throws std::invalid_argument if displacement is asked for and would grow without end
  std::vector<History> sample(std::span<const Point> points, std::size_t count, const Quantities& quantities);

private:
  void require_finite_displacement(const FieldSpectra& field) const;
  History history(const FieldSpectra& field, const DepthSpectra& spectra, double delay, std::size_t count,
                  const Quantities& quantities);

  /// factors_k spectrum_k as samples at the grid's times.
  std::vector<double> series(const Spectrum& spectrum, const Spectrum& factors, std::size_t count);
  std::vector<double> displacement(const Spectrum& velocity, const Spectrum& shift, double delay,
                                   double static_response, std::size_t count);

  /// Bins to samples at the grid's times.
  std::vector<double> on_grid(std::size_t count);

  FieldSetup setup_;
  Window window_;
  bool has_kink_;
  RealFourier fourier_;
  SignalSpectrum signal_;
  Spectrum shift_; ///< delay of a point along x, as factors of the bins
};

} // namespace tremolo::wavefield
