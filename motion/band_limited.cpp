#include "motion/band_limited.hpp"

#include "motion/fourier.hpp"

#include <algorithm>
#include <complex>
#include <numbers>

namespace tremolo::motion {

namespace {

using Complex = std::complex<double>;

/// Zeros that keep the ends of a record that begins and ends near zero from seeing each other on the window.
constexpr std::size_t least_gap = 64;

/// The transform of the samples and of zeros behind them, on a window of even length.
struct Spectrum {
  Spectrum(std::span<const double> samples, double step, std::size_t gap)
      : length(2 * fast_length((samples.size() + gap + 1) / 2)), dt(step) {
    std::vector<double> padded(samples.begin(), samples.end());
    padded.resize(length, 0.0);
    bins = transform(padded);
  }

  /// i w_k, 1/s.
  Complex s(std::size_t k) const {
    return {0.0, 2.0 * std::numbers::pi * static_cast<double>(k) / (static_cast<double>(length) * dt)};
  }

  std::size_t length;
  double dt;
  std::vector<Complex> bins;
};

/// The bins on a window of the same duration with `factor` as many samples. What was the Nyquist frequency is
/// counted twice there, as all others are.
std::vector<double> at_finer_steps(const Spectrum& spectrum, const std::vector<Complex>& bins,
                                   std::size_t factor, std::size_t count) {
  const std::size_t length = factor * spectrum.length;
  std::vector<Complex> wide(length / 2 + 1);
  std::ranges::transform(bins, wide.begin(), [&](Complex bin) { return bin * static_cast<double>(factor); });
  if (factor > 1)
    wide[spectrum.length / 2] *= 0.5;
  auto values = inverse_transform(wide, length);
  values.resize(count);
  return values;
}

std::vector<Complex> slopes_of(const Spectrum& spectrum) {
  auto bins = spectrum.bins;
  for (std::size_t k = 0; k < bins.size(); ++k)
    bins[k] *= spectrum.s(k);
  return bins;
}

} // namespace

std::vector<double> band_limited_integral(std::span<const double> samples, double dt, std::size_t before,
                                          std::size_t after) {
  Spectrum spectrum(samples, dt, samples.size() + before + after + least_gap);
  const std::size_t length = spectrum.length;
  const double mean = spectrum.bins[0].real() / static_cast<double>(length);
  spectrum.bins[0] = 0.0;
  for (std::size_t k = 1; k < spectrum.bins.size(); ++k)
    spectrum.bins[k] /= spectrum.s(k);
  const auto periodic = inverse_transform(spectrum.bins, length);
  // The middle of the zeros is as long before the record as after it.
  const auto at = [&](std::ptrdiff_t j) {
    const auto wrapped = static_cast<std::size_t>(j + static_cast<std::ptrdiff_t>(length)) % length;
    return periodic[wrapped] + mean * dt * static_cast<double>(j);
  };
  const double at_rest = at(-static_cast<std::ptrdiff_t>((length - samples.size()) / 2));
  std::vector<double> integral(before + samples.size() + after);
  for (std::size_t i = 0; i < integral.size(); ++i)
    integral[i] = at(static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(before)) - at_rest;
  return integral;
}

std::vector<double> band_limited_slope(std::span<const double> samples, double dt) {
  const Spectrum spectrum(samples, dt, least_gap);
  auto bins = slopes_of(spectrum);
  bins.back() = 0.0; // a cosine at the Nyquist frequency is level at its samples
  return at_finer_steps(spectrum, bins, 1, samples.size());
}

Refined refined(std::span<const double> samples, double dt, std::size_t factor) {
  const Spectrum spectrum(samples, dt, least_gap);
  const std::size_t count = factor * (samples.size() - 1) + 1;
  return {dt / static_cast<double>(factor), at_finer_steps(spectrum, spectrum.bins, factor, count),
          at_finer_steps(spectrum, slopes_of(spectrum), factor, count)};
}

} // namespace tremolo::motion
