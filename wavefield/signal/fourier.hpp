#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace tremolo::wavefield {

/// Discrete Fourier transforms of one real record of fixed length: plans and buffers are made once and
/// reused. Different ones may be used in different threads, but must be made in one: FFTW's planner is
/// shared.
class RealFourier {
public:
  explicit RealFourier(std::size_t length);
  ~RealFourier();
  RealFourier(const RealFourier&) = delete;
  RealFourier& operator=(const RealFourier&) = delete;

  std::span<double> samples();            ///< x_j, j = 0 .. length-1
  std::span<std::complex<double>> bins(); ///< X_k, k = 0 .. length/2

  /// X_k = sum_j x_j exp(-2 pi i j k / length)
  void forward();
  /// x_j = sum over all frequencies, negative ones included as conjugates, of X_k exp(2 pi i j k / length).
  /// Overwrites the bins.
  void inverse();

private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

/// The smallest even length >= `length` with no prime factor above 5, which FFTW does fast.
std::size_t fast_length(std::size_t length);

} // namespace tremolo::wavefield
