#include "motion/fourier.hpp"
#include "motion/make/pulses.hpp"
#include "motion/measures.hpp"
#include "motion/record.hpp"
#include "motion/spectra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>
#include <vector>

namespace tremolo::motion {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Measures, HarmonicMotion) {
  // a = A sin(w t) for 40 s of 2 Hz: Arias = pi/(2g) A^2 T/2; 5, 75 and 95 % are reached after whole periods,
  // at 2, 30 and 38 s; v = A/w (1 - cos(w t)) with peak 2A/w; d = A/w (t - sin(w t)/w) grows to A/w T; the
  // mean of |sin| is 2/pi.
  const double amplitude = 2.0;
  const double frequency = 2.0;
  const double duration = 40.0;
  const double dt = 1e-3;
  std::vector<double> a(40001);
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] = amplitude * std::sin(2.0 * pi * frequency * static_cast<double>(i) * dt);
  const auto m = measures(a, dt);
  EXPECT_NEAR(m.pga, amplitude, 1e-4);
  EXPECT_NEAR(m.pgv, amplitude / (pi * frequency), 1e-4);
  EXPECT_NEAR(m.pgd, amplitude / (2.0 * pi * frequency) * duration, 1e-3);
  EXPECT_NEAR(m.arias, pi / (2.0 * standard_gravity) * amplitude * amplitude * duration / 2.0, 1e-4);
  EXPECT_NEAR(m.cav, amplitude * 2.0 / pi * duration, 1e-3);
  EXPECT_NEAR(m.significant_duration, 36.0, 5e-3);
  EXPECT_NEAR(m.duration_5_75, 28.0, 5e-3);
  EXPECT_NEAR(m.mean_period, 1.0 / frequency, 5e-3); // leakage of the finite record
  EXPECT_NEAR(m.residual_velocity, 0.0, 1e-9);
  EXPECT_NEAR(m.residual_displacement, m.pgd, 1e-9);
  EXPECT_FALSE(residual_warning(m));
  EXPECT_THROW(measures(std::vector<double>{1.0}, dt), std::invalid_argument);
}

TEST(Measures, OfAVelocityKeepItsPeak) {
  const auto record = sampled({.amplitude = 0.3, .time = 2.0, .frequency = 2.0}, Unit::m_s, 0.01, 500);
  const auto m = measures(record);
  EXPECT_EQ(m.pgv, 0.3);
  // v = V (1 - 2 a) exp(-a): its slope is largest where (3 - 12 a + 4 a^2) = 0, a = (3 - sqrt(6))/2.
  const double a = 0.5 * (3.0 - std::sqrt(6.0));
  const double slope = 0.3 * 2.0 * pi * std::sqrt(a) * 2.0 * (3.0 - 2.0 * a) * std::exp(-a);
  EXPECT_NEAR(m.pga, slope, 0.005 * slope); // the peak falls between samples
}

TEST(Measures, ResidualVelocityIsWorthAWarning) {
  EXPECT_EQ(
      residual_warning({.pgv = 0.2, .residual_velocity = -0.05}),
      "residual velocity -0.05 m/s, 25 % of PGV: the motion does not end at rest; correct its baseline or "
      "filter it");
  EXPECT_FALSE(residual_warning({.pgv = 0.2, .residual_velocity = 0.0019}));
  EXPECT_FALSE(residual_warning({}));
}

class OscillatorOf : public ::testing::TestWithParam<double> {
protected:
  double damping = GetParam();
  double period = 0.7;
  double omega = 2.0 * pi / period;
  double root = std::sqrt(1.0 - damping * damping);
  double dt = 0.05;

  /// exp(-z w t) cos and sin of the damped motion.
  double cosine(double t) const { return std::exp(-damping * omega * t) * std::cos(omega * root * t); }
  double sine(double t) const { return std::exp(-damping * omega * t) * std::sin(omega * root * t); }
};

TEST_P(OscillatorOf, AStepIsTheClosedForm) {
  const auto u = oscillator(std::vector<double>(200, 2.0), dt, period, damping);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double t = static_cast<double>(i) * dt;
    const double exact = -2.0 / (omega * omega) * (1.0 - cosine(t) - damping / root * sine(t));
    ASSERT_NEAR(u[i], exact, 1e-15 + 1e-12 * 2.0 / (omega * omega)) << t;
  }
}

TEST_P(OscillatorOf, ARampIsTheClosedForm) {
  std::vector<double> ramp(200);
  for (std::size_t i = 0; i < ramp.size(); ++i)
    ramp[i] = 3.0 * static_cast<double>(i) * dt;
  const auto u = oscillator(ramp, dt, period, damping);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double t = static_cast<double>(i) * dt;
    const double z = damping;
    const double w = omega;
    const double exact =
        -3.0 / (w * w) *
        (t - 2.0 * z / w + 2.0 * z / w * cosine(t) + (2.0 * z * z - 1.0) / (w * root) * sine(t));
    ASSERT_NEAR(u[i], exact, 1e-12) << t;
  }
}

TEST_P(OscillatorOf, ASineConvergesAtOrderTwoToTheClosedForm) {
  // u = C sin(p t) + D cos(p t) + free part from rest; the input is only linear between samples.
  const double p = 5.0;
  const double r = p / omega;
  const double det = std::pow(1.0 - r * r, 2) + std::pow(2.0 * damping * r, 2);
  const double c = -(1.0 - r * r) / det / (omega * omega);
  const double d = 2.0 * damping * r / det / (omega * omega);
  const auto exact = [&](double t) {
    return c * std::sin(p * t) + d * std::cos(p * t) - d * cosine(t) -
           (c * p + damping * omega * d) / (omega * root) * sine(t);
  };
  const auto error = [&](double step) {
    std::vector<double> a(static_cast<std::size_t>(std::lround(10.0 / step)) + 1);
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] = std::sin(p * static_cast<double>(i) * step);
    const auto u = oscillator(a, step, period, damping);
    double largest = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i)
      largest = std::max(largest, std::abs(u[i] - exact(static_cast<double>(i) * step)));
    return largest;
  };
  EXPECT_NEAR(error(0.01) / error(0.005), 4.0, 0.05);
  EXPECT_LT(error(0.001), 1e-6 / (omega * omega) * 10.0);
}

INSTANTIATE_TEST_SUITE_P(Damping, OscillatorOf, ::testing::Values(0.0, 0.05, 0.6));

TEST(ResponseSpectrum, OfAStiffOscillatorIsThePeakOfTheGround) {
  const Pulse pulse{.amplitude = 3.0, .time = 1.0, .frequency = 2.0};
  const auto a = sampled(pulse, Unit::m_s2, 0.001, 3000).samples;
  const auto spectrum = response_spectrum(a, 0.001, std::vector{0.02, 0.5}, 0.05);
  EXPECT_NEAR(spectrum[0].acceleration, 3.0, 0.01);
  const double omega = 2.0 * pi / 0.5;
  EXPECT_DOUBLE_EQ(spectrum[1].velocity, omega * spectrum[1].displacement);
  EXPECT_DOUBLE_EQ(spectrum[1].acceleration, omega * omega * spectrum[1].displacement);
  EXPECT_THROW(oscillator(a, 0.001, 0.0, 0.05), std::invalid_argument);
  EXPECT_THROW(oscillator(a, 0.001, 1.0, 1.0), std::invalid_argument);
}

TEST(Periods, AreEvenlySpacedOnALogarithmicAxis) {
  const auto periods = spaced_periods(0.01, 10.0, 4);
  ASSERT_EQ(periods.size(), 4U);
  EXPECT_NEAR(periods[1], 0.1, 1e-15);
  EXPECT_NEAR(periods[3], 10.0, 1e-13);
  EXPECT_THROW(spaced_periods(1.0, 0.5, 4), std::invalid_argument);
  EXPECT_THROW(spaced_periods(0.1, 0.5, 1), std::invalid_argument);
}

TEST(FourierSpectrum, OfARickerPulseIsTheClosedForm) {
  // |V(f)| = 2/sqrt(pi) f^2/f0^3 exp(-(f/f0)^2) for a peak of 1.
  const double f0 = 3.0;
  const Pulse pulse{.time = 2.0, .frequency = f0};
  for (const auto& [f, amplitude] : fourier_spectrum(sampled(pulse, Unit::m_s, 0.01, 500).samples, 0.01))
    ASSERT_NEAR(amplitude, 2.0 / std::sqrt(pi) * f * f / (f0 * f0 * f0) * std::exp(-f * f / (f0 * f0)), 1e-12)
        << f;
}

TEST(Fourier, FastLengthsHaveSmallFactors) {
  EXPECT_EQ(fast_length(2000), 2000U);
  EXPECT_EQ(fast_length(2001), 2025U);
  EXPECT_EQ(fast_length(7), 8U);
}

TEST(Fourier, TransformOfAnyLengthAndBack) {
  for (const std::size_t n : {1U, 2U, 7U, 12U, 125U}) {
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i)
      x[i] = std::sin(1.7 * static_cast<double>(i * i));
    const auto bins = transform(x);
    ASSERT_EQ(bins.size(), n / 2 + 1);
    for (std::size_t j = 0; j < bins.size(); ++j) {
      std::complex<double> sum = 0.0;
      for (std::size_t k = 0; k < n; ++k)
        sum += x[k] * std::polar(1.0, -2.0 * pi * static_cast<double>(j * k) / static_cast<double>(n));
      ASSERT_NEAR(std::abs(bins[j] - sum), 0.0, 1e-11) << n << " " << j;
    }
    const auto again = inverse_transform(bins, n);
    for (std::size_t i = 0; i < n; ++i)
      ASSERT_NEAR(again[i], x[i], 1e-13) << n << " " << i;
  }
}

/// The names of the columns of PEER's NGA-West2 flatfile, T0.010S and so on up to T10.000S, without T and S.
TEST(Periods, CustomaryOnesAreTheColumnsOfTheFlatfile) {
  std::istringstream columns(
      "0.010 0.020 0.022 0.025 0.029 0.030 0.032 0.035 0.036 0.040 0.042 0.044 0.045 0.046 "
      "0.048 0.050 0.055 0.060 0.065 0.067 0.070 0.075 0.080 0.085 0.090 0.095 0.100 0.110 "
      "0.120 0.130 0.133 0.140 0.150 0.160 0.170 0.180 0.190 0.200 0.220 0.240 0.250 0.260 "
      "0.280 0.290 0.300 0.320 0.340 0.350 0.360 0.380 0.400 0.420 0.440 0.450 0.460 0.480 "
      "0.500 0.550 0.600 0.650 0.667 0.700 0.750 0.800 0.850 0.900 0.950 1.000 1.100 1.200 "
      "1.300 1.400 1.500 1.600 1.700 1.800 1.900 2.000 2.200 2.400 2.500 2.600 2.800 3.000 "
      "3.200 3.400 3.500 3.600 3.800 4.000 4.200 4.400 4.600 4.800 5.000 5.500 6.000 6.500 "
      "7.000 7.500 8.000 8.500 9.000 9.500 10.000");
  const std::vector<double> flatfile{std::istream_iterator<double>(columns), {}};
  const auto customary = customary_periods();
  EXPECT_EQ(std::vector<double>(customary.begin(), customary.end()), flatfile);
}

TEST(Periods, TabulatedOnesHoldTheCustomaryOnesOnce) {
  const auto customary = customary_periods();
  EXPECT_EQ(customary.size(), 105U);                 // of the 111 of NGA-West2 all up to 10 s
  const auto all = tabulated_periods(0.01, 10.0, 4); // 0.01, 0.1, 1 and 10 s are customary
  EXPECT_EQ(all, std::vector<double>(customary.begin(), customary.end()));
  const auto some = tabulated_periods(0.04, 5.0, 120);
  EXPECT_TRUE(std::ranges::is_sorted(some));
  EXPECT_EQ(some.front(), 0.04);
  EXPECT_EQ(some.back(), 5.0);
  for (const double period : {0.04, 0.075, 0.2, 0.3, 0.667, 1.0, 5.0})
    EXPECT_EQ(std::ranges::count(some, period), 1) << period;
  EXPECT_GT(some.size(), 190U);
}

} // namespace
} // namespace tremolo::motion
