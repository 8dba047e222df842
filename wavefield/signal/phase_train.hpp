#pragma once

#include <complex>
#include <cstddef>

namespace tremolo::wavefield {

/// Product without the C standard's recovery of infinities, which costs more than the product.
inline std::complex<double> times(std::complex<double> a, std::complex<double> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// exp(a + k b), k = 0, 1, 2, ...: a geometric sequence, started anew often enough to keep it at rounding.
class PhaseTrain {
public:
  PhaseTrain(std::complex<double> a, std::complex<double> b) : a_(a), b_(b), ratio_(std::exp(b)) {}

  std::complex<double> next() {
    value_ = k_ % restart == 0 ? std::exp(a_ + static_cast<double>(k_) * b_) : times(value_, ratio_);
    ++k_;
    return value_;
  }

private:
  static constexpr std::size_t restart = 32;
  std::complex<double> a_, b_, ratio_;
  std::complex<double> value_;
  std::size_t k_ = 0;
};

} // namespace tremolo::wavefield
