#include "mpm_domain/ranks/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

constexpr int digit_bits = 32;
constexpr std::uint64_t low_bits = 0xffffffff;
constexpr int lowest_exponent = -1074;

} // namespace

void ExactSum::add(double number) {
  constexpr int mantissa_bits = 52;
  constexpr std::uint64_t exponents = 0x7ff;
  const auto bits = std::bit_cast<std::uint64_t>(number);
  const std::uint64_t exponent = bits >> mantissa_bits & exponents;
  if (exponent == exponents) {
    ++parts_.back();
    return;
  }
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << mantissa_bits) - 1);
  const std::uint64_t mantissa = exponent > 0 ? fraction | std::uint64_t{1} << mantissa_bits : fraction;
  const std::uint64_t shift = exponent > 0 ? exponent - 1 : 0;
  const std::uint64_t within = shift % digit_bits;
  const std::uint64_t low = (mantissa & low_bits) << within;
  const std::uint64_t high = mantissa >> digit_bits << within;
  const std::int64_t sign = bits >> 63U != 0 ? -1 : 1;
  std::int64_t* const digit = &parts_[shift / digit_bits];
  digit[0] += sign * static_cast<std::int64_t>(low & low_bits);
  digit[1] += sign * static_cast<std::int64_t>((low >> digit_bits) + (high & low_bits));
  digit[2] += sign * static_cast<std::int64_t>(high >> digit_bits);
}

ExactSum& ExactSum::operator+=(const ExactSum& more) {
  for (std::size_t k = 0; k < parts_.size(); ++k)
    parts_[k] += more.parts_[k];
  return *this;
}

double ExactSum::value() const {
  if (parts_.back() != 0)
    return std::numeric_limits<double>::quiet_NaN();
  std::array<std::int64_t, digits> d{};
  // The sign of a sum is that of the carry out of its highest digit.
  const auto take_carries = [&](std::int64_t sign) {
    std::int64_t carry = 0;
    for (std::size_t k = 0; k < digits; ++k) {
      const std::int64_t digit = sign * parts_[k] + carry;
      d[k] = digit & static_cast<std::int64_t>(low_bits);
      carry = digit >> digit_bits;
    }
    return carry;
  };
  const double sign = take_carries(1) < 0 ? -1.0 : 1.0;
  if (sign < 0.0)
    take_carries(-1);
  const auto highest = std::find_if(d.rbegin(), d.rend(), [](std::int64_t digit) { return digit != 0; });
  const auto top = static_cast<std::ptrdiff_t>(d.rend() - highest) - 1;
  double sum = 0.0;
  for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, top - 2); k <= top; ++k)
    sum += std::ldexp(static_cast<double>(d[static_cast<std::size_t>(k)]),
                      digit_bits * static_cast<int>(k) + lowest_exponent);
  return sign * sum;
}

} // namespace tremolo::mpm_domain
