// Sums without rounding: they are the same in any order, and right where doubles added one by one are not.

#include "mpm_domain/ranks/exact_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

double sum_of(const std::vector<double>& numbers) {
  ExactSum sum;
  for (const double number : numbers)
    sum.add(number);
  return sum.value();
}

TEST(ExactSum, OfFewNumbersIsTheirSum) {
  EXPECT_EQ(sum_of({}), 0.0);
  EXPECT_EQ(sum_of({0.0, -0.0}), 0.0);
  EXPECT_EQ(sum_of({1.5, 2.25, -0.125}), 3.625);
  EXPECT_EQ(sum_of({-1e-300, -3e-310}), -1e-300 - 3e-310);
  EXPECT_EQ(sum_of({5e-324, 5e-324}), 1e-323);
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(sum_of({largest, largest, -largest}), largest);
}

TEST(ExactSum, KeepsWhatRoundingWouldLose) {
  EXPECT_EQ(sum_of({1e200, 1.0, -1e200}), 1.0);
  EXPECT_EQ(sum_of({1.0, 1e-30, -1.0}), 1e-30);
  EXPECT_EQ(sum_of({-1e16, -1.0, 1e16}), -1.0);
}

/// 10^5 numbers over 40 orders of magnitude and their opposites: nothing is left but the one number that has
/// none.
TEST(ExactSum, HasTheSameBitsInAnyOrder) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-20.0, 20.0);
  std::vector<double> numbers{0.1};
  for (int i = 0; i < 100000; ++i) {
    const double number = std::pow(10.0, exponent(random));
    numbers.insert(numbers.end(), {number, -number});
  }
  for (int order = 0; order < 3; ++order) {
    std::ranges::shuffle(numbers, random);
    EXPECT_EQ(sum_of(numbers), 0.1);
  }
}

/// Against long double, whose 64 bits hold the sum of these.
TEST(ExactSum, IsRoundedToTheLastBit) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int trial = 0; trial < 1000; ++trial) {
    const std::vector<double> numbers{number(random), number(random), number(random)};
    long double expected = 0.0L;
    for (const double n : numbers)
      expected += n;
    const double sum = sum_of(numbers);
    EXPECT_NEAR(sum, static_cast<double>(expected), std::abs(sum) * 0x1p-52);
  }
}

TEST(ExactSum, OfPartsIsTheSumOfAll) {
  ExactSum one, other;
  one.add(1e30);
  one.add(-2.0);
  other.add(-1e30);
  other.add(0.5);
  std::ranges::transform(one.parts(), other.parts(), one.parts().begin(), std::plus{});
  EXPECT_EQ(one.value(), -1.5);
}

TEST(ExactSum, OfWhatIsNotFiniteIsNotANumber) {
  EXPECT_TRUE(std::isnan(sum_of({1.0, std::numeric_limits<double>::infinity()})));
  EXPECT_TRUE(std::isnan(sum_of({std::numeric_limits<double>::quiet_NaN(), 1.0})));
}

} // namespace
} // namespace tremolo::mpm_domain
