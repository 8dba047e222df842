#pragma once

// Random variates that are the same on every machine: the standard fixes the bits of its generators, but
// leaves open what its own distributions make of them. Normal ones differ in the last bit at most, where the
// logarithm of the machine does.

#include <cmath>
#include <optional>
#include <random>
#include <utility>

namespace tremolo {

/// Uniform in [0, 1), with 53 bits.
inline double uniform(std::mt19937_64& generator) {
  constexpr double step = 0x1p-53;
  return static_cast<double>(generator() >> 11U) * step;
}

/// Two independent standard normal variates, by the polar method (Marsaglia & Bray 1964, SIAM Review 6,
/// 260-264).
/// @param symmetric  gives variates that are uniform in [-1, 1)
template <class Symmetric>
std::pair<double, double> normal_pair(Symmetric&& symmetric) {
  double x = 0.0;
  double y = 0.0;
  double square = 0.0;
  do {
    x = symmetric();
    y = symmetric();
    square = x * x + y * y;
  } while (square >= 1.0 || square == 0.0);
  const double scale = std::sqrt(-2.0 * std::log(square) / square);
  return {scale * x, scale * y};
}

/// Standard normal variates, one after the other.
class NormalVariates {
public:
  explicit NormalVariates(std::mt19937_64 generator) : generator_(generator) {}

  double operator()() {
    if (second_) {
      const double value = *second_;
      second_.reset();
      return value;
    }
    const auto [first, second] = normal_pair([this] { return 2.0 * uniform(generator_) - 1.0; });
    second_ = second;
    return first;
  }

private:
  std::mt19937_64 generator_;
  std::optional<double> second_;
};

} // namespace tremolo
