// The inlined exp, log and powers against the C library's in extended precision.

#include "materials/tensor/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>

namespace tremolo::materials {
namespace {

TEST(Elementary, ExpIsExactToTheLastDigits) {
  std::mt19937_64 random(1);
  for (const double range : {1e-6, 1.0, 20.0, 600.0}) {
    std::uniform_real_distribution<double> between(-range, range);
    for (int n = 0; n < 20000; ++n) {
      const double x = between(random);
      const long double expected = std::exp(static_cast<long double>(x));
      ASSERT_LE(std::abs(elementary::exp(x) / expected - 1.0L), 1e-15L) << x;
    }
  }
  EXPECT_EQ(elementary::exp(0.0), 1.0);
}

TEST(Elementary, LogIsExactToTheLastDigits) {
  std::mt19937_64 random(1);
  for (const double range : {1e-6, 1e-3, 1.0, 300.0}) { // also close to 1, where the logarithm vanishes
    std::uniform_real_distribution<double> between(-range, range);
    for (int n = 0; n < 20000; ++n) {
      const double x = std::exp(between(random));
      const long double expected = std::log(static_cast<long double>(x));
      ASSERT_LE(std::abs(elementary::log(x) - expected), 1e-15L * std::abs(expected)) << x;
    }
  }
  EXPECT_EQ(elementary::log(1.0), 0.0);
}

TEST(Elementary, PowersAreExactToTheirExponent) {
  std::mt19937_64 random(1);
  for (const double y : {-0.5, 0.2, 0.7, 3.0, 100.0}) {
    std::uniform_real_distribution<double> between(-6.0, 6.0);
    for (int n = 0; n < 20000; ++n) {
      const double x = std::exp(between(random));
      const long double expected = std::pow(static_cast<long double>(x), static_cast<long double>(y));
      const double size = 1.0 + std::abs(y * std::log(x));
      ASSERT_LE(std::abs(elementary::pow(x, y) / expected - 1.0L), 1e-15L * size) << x << "^" << y;
    }
  }
  EXPECT_EQ(elementary::pow(0.0, 3.0), 0.0);
  EXPECT_EQ(elementary::pow(0.0, 0.0), 1.0);
  EXPECT_EQ(elementary::pow(2.0, 0.0), 1.0);
  EXPECT_LT(elementary::pow(1e-12, 100.0), 1e-300); // 1e-1200
}

/// Four at a time: the bits of one at a time.
TEST(Elementary, FourAtATimeAreTheSameBits) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> between(-300.0, 300.0);
  for (int n = 0; n < 5000; ++n) {
    const Lanes x{between(random), between(random), 0.0, 1e-3 * between(random)};
    const Lanes e = elementary::exp(x);
    const Lanes l = elementary::log(e);
    const Lanes p = elementary::pow(e, 0.7);
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_EQ(e[i], elementary::exp(x[i])) << x[i];
      ASSERT_EQ(l[i], elementary::log(e[i])) << e[i];
      ASSERT_EQ(p[i], elementary::pow(e[i], 0.7)) << e[i];
    }
  }
}

} // namespace
} // namespace tremolo::materials
