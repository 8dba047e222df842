#pragma once

// exp and log in a few inlined multiplications, for laws that need several of them in every update: about
// twice as fast as calls into the C library, and the same bits whatever library a machine has. Relative error
// below 1e-15 for the finite results of normal arguments; no special values.

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace tremolo::materials::elementary {

/// e^x for |x| < 700, by e^x = 2^k e^r with |r| <= ln(2)/2 and the Taylor series of e^r to r^12.
inline double exp(double x) {
  constexpr double round = 6755399441055744.0; // 1.5 2^52: adding it leaves a whole number in the last bits
  constexpr double ln2_high = 6.93147180369123816490e-01;
  constexpr double ln2_low = 1.90821492927058770002e-10;
  const double shifted = std::fma(x, std::numbers::log2e, round);
  const double k = shifted - round;
  const double r = std::fma(-k, ln2_low, std::fma(-k, ln2_high, x));
  const double r2 = r * r;
  const double r4 = r2 * r2;
  const double a = std::fma(r2, std::fma(r, 1.0 / 6.0, 0.5), 1.0 + r);
  const double b = std::fma(r2, std::fma(r, 1.0 / 5040.0, 1.0 / 720.0), std::fma(r, 1.0 / 120.0, 1.0 / 24.0));
  const double c = std::fma(r2, std::fma(r, 1.0 / 39916800.0, 1.0 / 3628800.0),
                            std::fma(r, 1.0 / 362880.0, 1.0 / 40320.0));
  const double mantissa = std::fma(r4, std::fma(r4, std::fma(r4, 1.0 / 479001600.0, c), b), a);
  const auto exponent = std::bit_cast<std::uint64_t>(shifted) + 1023U;
  return mantissa * std::bit_cast<double>(exponent << 52U);
}

/// ln(x) for positive normal x, by x = 2^k m with m in [sqrt(1/2), sqrt(2)) and, with s = (m - 1)/(m + 1),
/// ln(m) = 2 (s + s^3/3 + s^5/5 + ...) to s^21.
inline double log(double x) {
  constexpr std::uint64_t sqrt_half = 0x3fe6a09e667f3bcdU;
  constexpr std::uint64_t exponent_bits = 0xfff0000000000000U;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t shift = (bits - sqrt_half) & exponent_bits;
  const double k = static_cast<double>(static_cast<std::int64_t>(shift) >> 52);
  const double m = std::bit_cast<double>(bits - shift);
  const double s = (m - 1.0) / (m + 1.0);
  const double t = s * s;
  const double t2 = t * t;
  const double t4 = t2 * t2;
  const double low = std::fma(t2, std::fma(t, 1.0 / 9.0, 1.0 / 7.0), std::fma(t, 1.0 / 5.0, 1.0 / 3.0));
  const double high = std::fma(t2, std::fma(t, 1.0 / 17.0, 1.0 / 15.0), std::fma(t, 1.0 / 13.0, 1.0 / 11.0));
  const double last = std::fma(t, 1.0 / 21.0, 1.0 / 19.0);
  const double series = t * std::fma(t4, std::fma(t4, last, high), low);
  return std::fma(k, std::numbers::ln2, 2.0 * std::fma(s, series, s));
}

} // namespace tremolo::materials::elementary
