#include "wavefield/signal/fourier.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace tremolo::wavefield;

TEST(RealFourier, InverseOfACosineBinIsACosine) {
  RealFourier fourier(12);
  for (auto& bin : fourier.bins()) {
    bin = 0.0;
  }
  fourier.bins()[2] = {0.5, -0.25}; // and its conjugate: cos + 1/2 sin
  fourier.inverse();
  for (std::size_t j = 0; j < 12; ++j) {
    const double angle = 2.0 * std::numbers::pi * 2.0 * static_cast<double>(j) / 12.0;
    EXPECT_NEAR(fourier.samples()[j], std::cos(angle) + 0.5 * std::sin(angle), 1e-14);
  }
}

TEST(RealFourier, ForwardIsTheDefinition) {
  RealFourier fourier(6);
  const double x[] = {1.0, -2.0, 0.5, 3.0, 0.0, -1.0};
  std::copy(std::begin(x), std::end(x), fourier.samples().begin());
  fourier.forward();
  for (std::size_t k = 0; k <= 3; ++k) {
    std::complex<double> sum = 0.0;
    for (std::size_t j = 0; j < 6; ++j) {
      sum += std::polar(x[j], -2.0 * std::numbers::pi * static_cast<double>(j * k) / 6.0);
    }
    EXPECT_NEAR(std::abs(fourier.bins()[k] - sum), 0.0, 1e-14);
  }
}

TEST(FastLength, IsTheNextEvenNumberOfSmallPrimes) {
  EXPECT_EQ(fast_length(1), 2U);
  EXPECT_EQ(fast_length(7), 8U);
  EXPECT_EQ(fast_length(1000), 1000U);
  EXPECT_EQ(fast_length(1001), 1024U);
  EXPECT_EQ(fast_length(15), 16U); // 15 itself is odd
}

} // namespace
