#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::motion {

/// The next length of which 2, 3 and 5 are the only factors: transforms of it are fast.
std::size_t fast_length(std::size_t n);

/// sum_k x_k exp(-2 pi i j k / n) for j = 0 .. n/2, any n >= 1.
std::vector<std::complex<double>> transform(std::span<const double> samples);

/// The n real samples of which the bins are the transform.
std::vector<double> inverse_transform(std::span<const std::complex<double>> bins, std::size_t n);

} // namespace tremolo::motion
