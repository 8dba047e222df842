#pragma once

// A sum of doubles that is not rounded until it is read. Every finite double is a multiple of 2^-1074, so a
// sum is an integer in digits of 32 bits,
//
//     s = 2^-1074 sum_k d_k 2^(32 k),
//
// and adding is exact (Kulisch 2013, Computer Arithmetic and Validity, ch. 8). So sums over tiles, rows of
// nodes and ranks have the same bits in whatever order and by whichever rank their terms are added.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tremolo::mpm_domain {

class ExactSum {
public:
  /// @pre fewer than 2^30 numbers are added, those of other sums included
  void add(double number);
  ExactSum& operator+=(const ExactSum& more);

  /// The sum, to the last bit or the one before it; NaN if a number was not finite.
  double value() const;

  /// Its digits. Two sums are added by adding their digits one by one.
  std::span<std::int64_t> parts() { return parts_; }

private:
  static constexpr std::size_t digits = 66;
  std::array<std::int64_t, digits + 1>
      parts_{}; ///< digits, carries not yet taken; numbers that are not finite
};

template <std::size_t count>
using ExactSums = std::array<ExactSum, count>;

} // namespace tremolo::mpm_domain
