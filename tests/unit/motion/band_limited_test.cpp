// Integral, slope and refinement of packets of waves, whose spectra end well below the Nyquist frequency,
// against their closed forms.

#include "motion/band_limited.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::motion {
namespace {

constexpr double dt = 0.01; // s; the Nyquist frequency is 50 Hz
constexpr std::size_t count = 401;
constexpr double centre = 2.0; // s
constexpr double width = 0.2;  // s

double envelope(double t) {
  return std::exp(-0.5 * std::pow((t - centre) / width, 2));
}

/// sin(omega (t - centre)) under the envelope, and its slope.
double value(double omega, double t) {
  return envelope(t) * std::sin(omega * (t - centre));
}
double slope(double omega, double t) {
  const double s = t - centre;
  return envelope(t) * (omega * std::cos(omega * s) - s / (width * width) * std::sin(omega * s));
}

std::vector<double> samples(double (*function)(double, double), double omega, double step = dt) {
  std::vector<double> all;
  const auto steps = static_cast<std::size_t>(std::lround(static_cast<double>(count - 1) * dt / step));
  for (std::size_t i = 0; i <= steps; ++i)
    all.push_back(function(omega, static_cast<double>(i) * step));
  return all;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

constexpr double omega = 2.0 * std::numbers::pi * 42.0; // at 84 % of the Nyquist frequency

TEST(BandLimited, SlopeAndIntegralUndoEachOther) {
  EXPECT_LT(largest_difference(band_limited_slope(samples(value, omega), dt), samples(slope, omega)),
            1e-9 * omega);
  EXPECT_LT(largest_difference(band_limited_integral(samples(slope, omega), dt, 0, 0), samples(value, omega)),
            1e-9);
}

TEST(BandLimited, IntegralIsKnownBeforeAndAfterTheSamples) {
  // The area of the envelope stays.
  std::vector<double> bell;
  for (std::size_t i = 0; i < count; ++i)
    bell.push_back(envelope(static_cast<double>(i) * dt));
  const auto integral = band_limited_integral(bell, dt, 10, 50);
  ASSERT_EQ(integral.size(), count + 60);
  const double area = width * std::sqrt(2.0 * std::numbers::pi);
  EXPECT_NEAR(integral.front(), 0.0, 1e-12);
  EXPECT_NEAR(integral[10 + count - 1], area, 1e-12);
  EXPECT_NEAR(integral.back(), area, 1e-12);
  EXPECT_NEAR(integral[10 + (count - 1) / 2], 0.5 * area, 1e-12);
}

TEST(BandLimited, RefinedAgreesWithTheFunctionBetweenTheSamples) {
  for (const std::size_t factor : {1, 3, 8}) {
    const Refined fine = refined(samples(value, omega), dt, factor);
    EXPECT_DOUBLE_EQ(fine.dt, dt / static_cast<double>(factor));
    EXPECT_LT(largest_difference(fine.value, samples(value, omega, fine.dt)), 1e-9) << factor;
    EXPECT_LT(largest_difference(fine.slope, samples(slope, omega, fine.dt)), 1e-9 * omega) << factor;
  }
}

TEST(BandLimited, RefinedPassesThroughSamplesOfAnyKind) {
  // Up to the Nyquist frequency itself: neighbours of opposite sign.
  std::vector<double> rough;
  for (std::size_t i = 0; i < 37; ++i)
    rough.push_back(std::sin(0.1 * static_cast<double>(i * i)) + (i % 2 == 0 ? 1.0 : -1.0));
  const Refined fine = refined(rough, dt, 4);
  for (std::size_t i = 0; i < rough.size(); ++i)
    EXPECT_NEAR(fine.value[4 * i], rough[i], 1e-12) << i;
}

} // namespace
} // namespace tremolo::motion
