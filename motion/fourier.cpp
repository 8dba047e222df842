#include "motion/fourier.hpp"

#include "motion/gsl_calls.hpp"

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>

namespace tremolo::motion {

std::size_t fast_length(std::size_t n) {
  const auto is_fast = [](std::size_t length) {
    for (const std::size_t factor : {2U, 3U, 5U})
      while (length % factor == 0)
        length /= factor;
    return length == 1;
  };
  while (!is_fast(n))
    ++n;
  return n;
}

// GSL packs the transform of a real sequence as r0, r1, i1, r2, i2, ...; even lengths end with r(n/2).
std::vector<std::complex<double>> transform(std::span<const double> samples) {
  const std::size_t n = samples.size();
  std::vector<double> packed(samples.begin(), samples.end());
  const auto table = owned(gsl_fft_real_wavetable_alloc, gsl_fft_real_wavetable_free, n);
  const auto space = owned(gsl_fft_real_workspace_alloc, gsl_fft_real_workspace_free, n);
  check(gsl_fft_real_transform(packed.data(), 1, n, table.get(), space.get()));
  std::vector<std::complex<double>> bins(n / 2 + 1);
  bins[0] = packed[0];
  for (std::size_t j = 1; j < bins.size(); ++j)
    bins[j] = {packed[2 * j - 1], 2 * j < n ? packed[2 * j] : 0.0};
  return bins;
}

std::vector<double> inverse_transform(std::span<const std::complex<double>> bins, std::size_t n) {
  std::vector<double> packed(n);
  packed[0] = bins[0].real();
  for (std::size_t j = 1; j < n / 2 + 1; ++j) {
    packed[2 * j - 1] = bins[j].real();
    if (2 * j < n)
      packed[2 * j] = bins[j].imag();
  }
  const auto table = owned(gsl_fft_halfcomplex_wavetable_alloc, gsl_fft_halfcomplex_wavetable_free, n);
  const auto space = owned(gsl_fft_real_workspace_alloc, gsl_fft_real_workspace_free, n);
  check(gsl_fft_halfcomplex_inverse(packed.data(), 1, n, table.get(), space.get()));
  return packed;
}

} // namespace tremolo::motion
