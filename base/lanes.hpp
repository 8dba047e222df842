#pragma once

// Four doubles that are loaded, multiplied and stored together: one quantity of four particles or points, or
// of four neighbouring nodes of a row of the grid. Where a function is also there for one double, templates
// over Real = double or Lanes do with both what they do with one.

#include <immintrin.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tremolo {

using Lanes = double __attribute__((vector_size(32)));

/// Lanes at an address that need not be aligned.
using LanesInMemory = double __attribute__((vector_size(32), aligned(8), may_alias));

/// Mask of the four lanes: all bits of an active lane are set, none of the others.
using LaneMask = std::int64_t __attribute__((vector_size(32)));

inline Lanes load(const double* first) {
  return *reinterpret_cast<const LanesInMemory*>(first);
}

inline void store(double* first, const Lanes& values) {
  *reinterpret_cast<LanesInMemory*>(first) = values;
}

/// One number in all four.
inline Lanes all(double value) {
  return Lanes{value, value, value, value};
}

inline Lanes floor(const Lanes& a) {
  return _mm256_floor_pd(a);
}

inline double floor(double a) {
  return std::floor(a);
}

/// a in the lanes of a mask, b in the others.
inline Lanes choose(const LaneMask& mask, const Lanes& a, const Lanes& b) {
  return mask ? a : b;
}

inline double choose(bool mask, double a, double b) {
  return mask ? a : b;
}

/// Whether a mask holds for any of the four.
inline bool any(const LaneMask& mask) {
  return _mm256_movemask_pd(reinterpret_cast<const __m256d&>(mask)) != 0;
}
inline bool any(bool mask) {
  return mask;
}

/// One number as a Real.
template <typename Real>
Real constant(double value) {
  if constexpr (std::is_same_v<Real, Lanes>)
    return all(value);
  else
    return value;
}

/// 1/a in the lanes of a mask, 0 in the others.
inline Lanes inverse(const Lanes& a, const LaneMask& mask) {
  return choose(mask, 1.0 / choose(mask, a, all(1.0)), Lanes{});
}

/// max(a, 0); zero where a is not a number.
inline Lanes positive(const Lanes& a) {
  return _mm256_max_pd(a, Lanes{});
}

inline double positive(double a) {
  return a > 0.0 ? a : 0.0;
}

inline Lanes sqrt(const Lanes& a) {
  return _mm256_sqrt_pd(a);
}

inline double sqrt(double a) {
  return std::sqrt(a);
}

inline Lanes magnitude(const Lanes& a) {
  return _mm256_andnot_pd(all(-0.0), a);
}

/// a b + c, rounded once.
inline Lanes fma(const Lanes& a, const Lanes& b, const Lanes& c) {
  return _mm256_fmadd_pd(a, b, c);
}
inline double fma(double a, double b, double c) {
  return std::fma(a, b, c);
}

/// a limited to [low, high]; low where a is not a number.
inline Lanes clamp(const Lanes& a, double low, double high) {
  return _mm256_min_pd(_mm256_max_pd(a, all(low)), all(high));
}

/// The larger of each lane; b where a is not a number.
inline Lanes larger(const Lanes& a, const Lanes& b) {
  return _mm256_max_pd(a, b);
}

inline double larger(double a, double b) {
  return a > b ? a : b;
}

/// The smaller of each lane; b where a is not a number.
inline Lanes smaller(const Lanes& a, const Lanes& b) {
  return _mm256_min_pd(a, b);
}

inline double smaller(double a, double b) {
  return a < b ? a : b;
}

/// Row k of the result holds lane k of each of the four.
inline std::array<Lanes, 4> transposed(const std::array<Lanes, 4>& rows) {
  const Lanes a = _mm256_permute2f128_pd(rows[0], rows[2], 0x20);
  const Lanes b = _mm256_permute2f128_pd(rows[1], rows[3], 0x20);
  const Lanes c = _mm256_permute2f128_pd(rows[0], rows[2], 0x31);
  const Lanes d = _mm256_permute2f128_pd(rows[1], rows[3], 0x31);
  return {_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b), _mm256_unpacklo_pd(c, d),
          _mm256_unpackhi_pd(c, d)};
}

inline double sum(const Lanes& a) {
  return (a[0] + a[1]) + (a[2] + a[3]);
}

/// Whole groups of four numbers in an array.
struct Four {
  static constexpr std::size_t count = 4;
  Lanes load(const double* first) const { return tremolo::load(first); }
  void store(double* first, const Lanes& values) const { tremolo::store(first, values); }
  /// a in the lanes that are there, b in the others.
  Lanes present(const Lanes& a, const Lanes&) const { return a; }
};

/// The one to three numbers that are left at its end: absent lanes load zero and are not stored.
struct FewerThanFour {
  std::size_t count;
  LaneMask mask;

  explicit FewerThanFour(std::size_t n)
      : count(n), mask(LaneMask{0, 1, 2, 3} < LaneMask{} + static_cast<std::int64_t>(n)) {}
  Lanes load(const double* first) const {
    return _mm256_maskload_pd(first, reinterpret_cast<const __m256i&>(mask));
  }
  void store(double* first, const Lanes& values) const {
    _mm256_maskstore_pd(first, reinterpret_cast<const __m256i&>(mask), values);
  }
  Lanes present(const Lanes& a, const Lanes& b) const { return choose(mask, a, b); }
};

/// act(k, group) for the numbers [begin, end), four at a time.
template <typename Act>
[[gnu::always_inline]] inline void by_fours(std::size_t begin, std::size_t end, const Act& act) {
  std::size_t k = begin;
  for (; k + 4 <= end; k += 4)
    act(k, Four{});
  if (k < end)
    act(k, FewerThanFour(end - k));
}

} // namespace tremolo
