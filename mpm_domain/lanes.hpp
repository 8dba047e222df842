#pragma once

// Four doubles that are loaded, multiplied and stored together: four neighbouring nodes of a row of the grid.

#include <immintrin.h>

namespace tremolo::mpm_domain {

using Lanes = double __attribute__((vector_size(32)));

/// The same, anywhere in memory.
using LanesInMemory = double __attribute__((vector_size(32), aligned(8), may_alias));

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

inline Lanes magnitude(const Lanes& a) {
  return _mm256_andnot_pd(all(-0.0), a);
}

/// Held within [-1, 1].
inline Lanes clamped(const Lanes& a) {
  return _mm256_min_pd(_mm256_max_pd(a, all(-1.0)), all(1.0));
}

/// { sum of a, sum of b, sum of c, sum of d }
inline Lanes sums(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  const Lanes ab = _mm256_hadd_pd(a, b); // { a0 + a1, b0 + b1, a2 + a3, b2 + b3 }
  const Lanes cd = _mm256_hadd_pd(c, d);
  const Lanes low = _mm256_blend_pd(ab, cd, 0b1100);
  const Lanes high = _mm256_permute2f128_pd(ab, cd, 0x21);
  return low + high;
}

inline double sum(const Lanes& a) {
  return (a[0] + a[1]) + (a[2] + a[3]);
}

} // namespace tremolo::mpm_domain
