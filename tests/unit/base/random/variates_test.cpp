#include "base/random/variates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>

namespace tremolo {
namespace {

// The 10000th number of mt19937_64 with its default seed is fixed by the standard, [rand.predef].
TEST(Variates, UniformOnesAreTheUpperBitsOfTheGenerator) {
  std::mt19937_64 generator;
  for (int i = 1; i < 10000; ++i)
    uniform(generator);
  EXPECT_EQ(static_cast<double>(9981545732273789042ULL >> 11U) / 9007199254740992.0, uniform(generator));
}

TEST(Variates, NormalOnesHaveTheMomentsOfANormalDistribution) {
  constexpr std::size_t count = 200000;
  NormalVariates normal{std::mt19937_64(3)};
  double first = 0.0;
  double second = 0.0;
  double third = 0.0;
  double fourth = 0.0;
  double beyond = 0.0;
  double neighbours = 0.0;
  double before = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = normal();
    first += z;
    second += z * z;
    third += z * z * z;
    fourth += z * z * z * z;
    beyond += std::abs(z) > 2.0 ? 1.0 : 0.0;
    neighbours += z * before;
    before = z;
  }
  // Standard deviations of means of z, z^2, z^3, z^4 and of a share; four of them.
  const auto near = [&](double sum, double mean, double variance) {
    EXPECT_LT(std::abs(sum / count - mean), 4.0 * std::sqrt(variance / count)) << sum / count;
  };
  const double share = std::erfc(std::sqrt(2.0));
  near(first, 0.0, 1.0);
  near(second, 1.0, 2.0);
  near(third, 0.0, 15.0);
  near(fourth, 3.0, 96.0);
  near(beyond, share, share * (1.0 - share));
  near(neighbours, 0.0, 1.0);
}

TEST(Variates, TheSeedDecides) {
  NormalVariates one{std::mt19937_64(5)};
  NormalVariates same{std::mt19937_64(5)};
  NormalVariates other{std::mt19937_64(6)};
  const double first = one();
  EXPECT_EQ(first, same());
  EXPECT_NE(first, other());
}

} // namespace
} // namespace tremolo
