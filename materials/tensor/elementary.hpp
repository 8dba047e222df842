#pragma once

// exp, log and powers in a few inlined multiplications, for laws that need several of them in every update:
// about twice as fast as calls into the C library, and the same bits whatever library a machine has. Relative
// error below 1e-15 for the finite results of normal arguments; no special values. Real is double, or Lanes
// for four numbers at a time.

#include "base/lanes.hpp"

#include <bit>
#include <cstdint>
#include <numbers>

namespace tremolo::materials::elementary {

template <typename Real>
struct BitsOf {
  using Type = std::uint64_t;
};
template <>
struct BitsOf<Lanes> {
  using Type = std::uint64_t __attribute__((vector_size(32)));
};
/// The bits of a Real, as whole numbers.
template <typename Real>
using Bits = typename BitsOf<Real>::Type;

/// e^x for |x| < 700, by e^x = 2^k e^r with |r| <= ln(2)/2 and the Taylor series of e^r to r^12.
template <typename Real>
[[gnu::always_inline]] inline Real exp(const Real& x) {
  constexpr double round = 6755399441055744.0; // 1.5 2^52: adding it leaves a whole number in the last bits
  constexpr double ln2_high = 6.93147180369123816490e-01;
  constexpr double ln2_low = 1.90821492927058770002e-10;
  const auto of = [](double value) { return constant<Real>(value); };
  const Real shifted = fma(x, of(std::numbers::log2e), of(round));
  const Real k = shifted - round;
  const Real r = fma(-k, of(ln2_low), fma(-k, of(ln2_high), x));
  const Real r2 = r * r;
  const Real r4 = r2 * r2;
  const Real a = fma(r2, fma(r, of(1.0 / 6.0), of(0.5)), 1.0 + r);
  const Real b = fma(r2, fma(r, of(1.0 / 5040.0), of(1.0 / 720.0)), fma(r, of(1.0 / 120.0), of(1.0 / 24.0)));
  const Real c = fma(r2, fma(r, of(1.0 / 39916800.0), of(1.0 / 3628800.0)),
                     fma(r, of(1.0 / 362880.0), of(1.0 / 40320.0)));
  const Real mantissa = fma(r4, fma(r4, fma(r4, of(1.0 / 479001600.0), c), b), a);
  const Bits<Real> exponent = std::bit_cast<Bits<Real>>(shifted) + std::uint64_t{1023};
  return mantissa * std::bit_cast<Real>(exponent << std::uint64_t{52});
}

/// ln(x) for positive normal x, by x = 2^k m with m in [sqrt(1/2), sqrt(2)) and, with s = (m - 1)/(m + 1),
/// ln(m) = 2 (s + s^3/3 + s^5/5 + ...) to s^21.
template <typename Real>
[[gnu::always_inline]] inline Real log(const Real& x) {
  constexpr std::uint64_t sqrt_half = 0x3fe6a09e667f3bcdU;
  constexpr std::uint64_t exponent_bits = 0xfff0000000000000U;
  constexpr std::uint64_t two52 = 0x4330000000000000U; // the bits of 2^52: it counts in its last ones
  constexpr std::uint64_t bias = 2048;
  const auto of = [](double value) { return constant<Real>(value); };
  const Bits<Real> bits = std::bit_cast<Bits<Real>>(x);
  const Bits<Real> shift = (bits - sqrt_half) & exponent_bits;
  const Bits<Real> counted = ((shift >> std::uint64_t{52}) ^ bias) | two52; // 2^52 + 2048 + k
  const Real k = std::bit_cast<Real>(counted) - (4503599627370496.0 + static_cast<double>(bias));
  const Real m = std::bit_cast<Real>(bits - shift);
  const Real s = (m - 1.0) / (m + 1.0);
  const Real t = s * s;
  const Real t2 = t * t;
  const Real t4 = t2 * t2;
  const Real low = fma(t2, fma(t, of(1.0 / 9.0), of(1.0 / 7.0)), fma(t, of(1.0 / 5.0), of(1.0 / 3.0)));
  const Real high = fma(t2, fma(t, of(1.0 / 17.0), of(1.0 / 15.0)), fma(t, of(1.0 / 13.0), of(1.0 / 11.0)));
  const Real last = fma(t, of(1.0 / 21.0), of(1.0 / 19.0));
  const Real series = t * fma(t4, fma(t4, last, high), low);
  return fma(k, of(std::numbers::ln2), 2.0 * fma(s, series, s));
}

/// x^y for x that is 0 or positive and normal, with 0^0 = 1; at most e^700, at least e^-700 where x is not 0.
/// Relative error 1e-15 (1 + |y ln(x)|).
template <typename Real>
[[gnu::always_inline]] inline Real pow(const Real& x, double y) {
  const auto of = [](double value) { return constant<Real>(value); };
  const Real exponent = smaller(of(700.0), larger(of(-700.0), y * log(x)));
  return choose(x > 0.0, exp(exponent), of(y == 0.0 ? 1.0 : 0.0));
}

} // namespace tremolo::materials::elementary
