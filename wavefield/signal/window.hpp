#pragma once

#include "wavefield/signal/history.hpp"

#include <complex>
#include <cstddef>

namespace tremolo::wavefield {

/// A time interval, s.
struct Interval {
  double begin = 0.0;
  double end = 0.0;
};

/// The periodic time window of the Fourier synthesis: samples start + j dt. Time i of the requested grid is
/// sample offset + i stride. Bin k of a spectrum belongs to s = i omega(k) + epsilon.
struct Window {
  double start = 0.0; ///< s
  double dt = 0.0;    ///< s
  std::size_t length = 0;
  std::size_t offset = 0;
  std::size_t stride = 1;
  double epsilon = 0.0; ///< 1/s; what wraps around once is damped by exp(-epsilon duration())

  double duration() const { return static_cast<double>(length) * dt; } ///< s
  double omega(std::size_t bin) const;                                 ///< 1/s
  std::complex<double> s(std::size_t bin) const { return {epsilon, omega(bin)}; }
};

/// A window of `padding` times the interval, which lies in its middle; aligned with the grid and fine enough
/// for a signal up to the highest frequency (Hz).
/// @throws std::invalid_argument if that needs more samples than fit in memory
Window make_window(const TimeGrid& grid, const Interval& interval, double padding, double highest_frequency);

/// A window for causal fields: the interval lies at its beginning, and epsilon damps the wrapped-around
/// signal to 1e-7.
Window make_exponential_window(const TimeGrid& grid, const Interval& interval, double padding,
                               double highest_frequency);

} // namespace tremolo::wavefield
