#include "base/samples.hpp"
#include "motion/fourier.hpp"
#include "motion/make/pulses.hpp"
#include "motion/mend/process.hpp"
#include "motion/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::motion {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<double> sine(double frequency, double dt, std::size_t count) {
  std::vector<double> samples(count);
  for (std::size_t i = 0; i < count; ++i)
    samples[i] = std::sin(2.0 * pi * frequency * static_cast<double>(i) * dt + 0.3);
  return samples;
}

TEST(Taper, IsHalfACosineAtBothEnds) {
  const auto tapered_ones = tapered(std::vector<double>(101, 1.0), 0.1, 2.0, 4.0);
  EXPECT_EQ(tapered_ones.front(), 0.0);
  EXPECT_NEAR(tapered_ones[10], 0.5, 1e-14);
  EXPECT_NEAR(tapered_ones[5], 0.5 * (1.0 - std::cos(pi / 4.0)), 1e-14);
  EXPECT_EQ(tapered_ones[20], 1.0);
  EXPECT_EQ(tapered_ones[60], 1.0);
  EXPECT_NEAR(tapered_ones[80], 0.5, 1e-12);
  EXPECT_NEAR(tapered_ones.back(), 0.0, 1e-14);
  EXPECT_THROW(tapered({0.0, 1.0, 2.0}, 0.1, 0.15, 0.15), std::invalid_argument);
  EXPECT_THROW(tapered({0.0, 1.0, 2.0}, 0.1, -0.1, 0.1), std::invalid_argument);
}

TEST(Scale, ToAPeak) {
  EXPECT_EQ(scaled_to_peak({1.0, -4.0}, 2.0), (std::vector{0.5, -2.0}));
  EXPECT_THROW(scaled_to_peak({0.0, 0.0}, 2.0), std::invalid_argument);
  EXPECT_THROW(scaled_to_peak({1.0, 0.0}, -2.0), std::invalid_argument);
}

TEST(Rotation, TurnsTheAxes) {
  const std::vector<double> first = {3.0, 1.0};
  const std::vector<double> second = {4.0, -1.0};
  const auto quarter = rotated(first, second, 90.0);
  EXPECT_NEAR(quarter.first[0], 4.0, 1e-14);
  EXPECT_NEAR(quarter.second[0], -3.0, 1e-14);
  const auto along = rotated(first, second, std::atan2(4.0, 3.0) * 180.0 / pi);
  EXPECT_NEAR(along.first[0], 5.0, 1e-14);
  EXPECT_NEAR(along.second[0], 0.0, 1e-14);
  EXPECT_THROW(rotated(first, std::vector{1.0}, 90.0), std::invalid_argument);
}

TEST(Shift, ByWholeStepsMovesSamples) {
  const std::vector<double> samples = {1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(shifted(samples, 0.1, 0.2), (std::vector{0.0, 0.0, 1.0, 2.0, 3.0, 4.0}));
  EXPECT_EQ(shifted(samples, 0.1, -0.2), (std::vector{3.0, 4.0}));
  EXPECT_THROW(shifted(samples, 0.1, -0.3), std::invalid_argument);
  EXPECT_THROW(shifted(samples, 0.1, 1e9), std::invalid_argument);
}

TEST(Shift, ByAPartOfAStepInterpolates) {
  const double dt = 0.01;
  const Pulse pulse{.time = 2.0, .frequency = 5.0};
  Pulse later = pulse;
  later.time += 0.1234;
  const auto moved = shifted(sampled(pulse, Unit::m_s, dt, 400).samples, dt, 0.1234);
  for (std::size_t i = 0; i < moved.size(); ++i)
    ASSERT_NEAR(moved[i], value(later, static_cast<double>(i) * dt), 1e-6) << i;
}

/// Largest error of a sine resampled, `margin` s away from its ends.
double sine_error(double frequency, double dt, double new_dt, double margin) {
  const double duration = 20.0;
  const auto fine =
      resampled(sine(frequency, dt, static_cast<std::size_t>(std::lround(duration / dt)) + 1), dt, new_dt);
  const auto exact = sine(frequency, new_dt, fine.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double t = static_cast<double>(i) * new_dt;
    if (t > margin && t < duration - margin)
      largest = std::max(largest, std::abs(fine[i] - exact[i]));
  }
  return largest;
}

TEST(Resampling, SinesBelowNyquistAreExact) {
  for (const double part : {0.01, 0.2, 0.5, 0.8, 0.85}) {
    EXPECT_LT(sine_error(part * 50.0, 0.01, 0.003, 1.0), 1e-6) << part;  // finer
    EXPECT_LT(sine_error(part * 50.0, 0.01, 0.0099, 1.0), 1e-6) << part; // hardly finer
    EXPECT_LT(sine_error(part * 12.5, 0.01, 0.04, 4.0), 1e-6) << part;   // coarser
  }
}

TEST(Resampling, WhatTheCoarserStepCannotCarryIsGone) {
  for (const double frequency : {12.6, 20.0, 24.0, 49.0}) { // the new Nyquist frequency is 12.5 Hz
    const auto coarse = resampled(sine(frequency, 0.01, 2001), 0.01, 0.04);
    for (std::size_t i = 100; i + 100 < coarse.size(); ++i)
      ASSERT_LT(std::abs(coarse[i]), 1e-6) << frequency << " Hz, " << i;
  }
}

TEST(Resampling, ARickerPulseGetsNoTails) {
  const Pulse pulse{.time = 5.0, .frequency = 4.0};
  const auto samples = sampled(pulse, Unit::m_s, 0.02, 501).samples;
  for (const double dt : {0.003, 0.01, 0.025}) {
    const auto again = resampled(samples, 0.02, dt);
    for (std::size_t i = 0; i < again.size(); ++i)
      ASSERT_NEAR(again[i], value(pulse, static_cast<double>(i) * dt), 1e-6) << dt << " " << i;
  }
}

TEST(Resampling, KeepsConstantsAndLinesUpToTheEnds) {
  std::vector<double> line(200);
  for (std::size_t i = 0; i < line.size(); ++i)
    line[i] = 3.0 + 0.1 * static_cast<double>(i);
  const auto fine = resampled(line, 0.01, 0.004);
  ASSERT_EQ(fine.size(), 498U);
  for (std::size_t i = 0; i < fine.size(); ++i)
    ASSERT_NEAR(fine[i], 3.0 + 0.04 * static_cast<double>(i), 1e-6) << i;
  EXPECT_EQ(resampled(line, 0.01, 0.01), line);
  EXPECT_THROW(resampled(line, 0.01, 0.0), std::invalid_argument);
  EXPECT_THROW(resampled(line, 0.01, 3.0), std::invalid_argument);
  EXPECT_THROW(resampled(line, 0.01, 1e-9), std::invalid_argument);
}

/// Gain of forward and backward pass, with W = tan(pi f dt).
double butterworth_gain(const Band& band, double f, double dt) {
  const auto w = [dt](double frequency) { return std::tan(pi * frequency * dt); };
  double gain = 1.0;
  if (band.low > 0.0)
    gain /= 1.0 + std::pow(w(band.low) / w(f), 2 * band.order);
  if (band.high > 0.0)
    gain /= 1.0 + std::pow(w(f) / w(band.high), 2 * band.order);
  return gain;
}

TEST(BandPass, GainIsTheClosedFormAndPhaseIsZero) {
  const double dt = 0.01;
  const std::size_t count = 16384;
  std::vector<double> impulse(count, 0.0);
  impulse[count / 2] = 1.0;
  for (const Band& band : {Band{0.3, 20.0, 4}, Band{0.5, 0.0, 3}, Band{0.0, 10.0, 1}, Band{1.0, 30.0, 5},
                           Band{1.0, 5.0, 10}, Band{0.0, 49.0, 2}}) {
    const auto bins = transform(band_passed(impulse, dt, band));
    for (std::size_t j = 1; j + 1 < bins.size(); ++j) {
      const double f = static_cast<double>(j) / (static_cast<double>(count) * dt);
      // The impulse in the middle gives the alternating sign; its response is cut at the record's start.
      const auto gain = bins[j] * (j % 2 == 0 ? 1.0 : -1.0);
      ASSERT_NEAR(gain.real(), butterworth_gain(band, f, dt), 1e-8) << band.order << " at " << f;
      ASSERT_NEAR(gain.imag(), 0.0, 1e-8) << band.order << " at " << f;
    }
  }
}

TEST(BandPass, RefusesCornersOutOfOrder) {
  const std::vector<double> samples(100, 1.0);
  for (const Band& band : {Band{0.0, 0.0, 4}, Band{5.0, 1.0, 4}, Band{1.0, 50.0, 4}, Band{-1.0, 5.0, 4},
                           Band{1.0, 5.0, 0}, Band{1.0, 5.0, 11}, Band{1e-9, 5.0, 4}})
    EXPECT_THROW(band_passed(samples, 0.01, band), std::invalid_argument)
        << band.low << " " << band.high << " " << band.order;
}

TEST(Baseline, RemovesAPolynomialAndEndsAtRest) {
  // A motion at rest at both ends, and a drift that is itself a polynomial: it is found exactly where the
  // motion is too small to be taken for a drift.
  const double dt = 0.01;
  std::vector<double> drift(2001);
  for (std::size_t i = 0; i < drift.size(); ++i) {
    const double t = static_cast<double>(i) * dt;
    drift[i] = 0.05 - 0.01 * t + 0.0004 * t * t;
  }
  for (const auto& [fit, degree] :
       {std::pair{BaselineFit::velocity, 3}, {BaselineFit::displacement, 4}, {BaselineFit::velocity, 6}})
    EXPECT_LT(peak(baseline_corrected(drift, dt, fit, degree)), 1e-12) << degree;
  auto motion = sine(1.0, dt, 2001);
  for (std::size_t i = 0; i < motion.size(); ++i)
    motion[i] += drift[i];
  for (const auto& [fit, degree] :
       {std::pair{BaselineFit::velocity, 1}, {BaselineFit::velocity, 3}, {BaselineFit::displacement, 2}}) {
    const auto velocity = integrate(baseline_corrected(motion, dt, fit, degree), dt);
    EXPECT_LT(std::abs(velocity.back()), 1e-12) << degree;
  }
  EXPECT_THROW(baseline_corrected(drift, dt, BaselineFit::velocity, 0), std::invalid_argument);
  EXPECT_THROW(baseline_corrected(drift, dt, BaselineFit::displacement, 1), std::invalid_argument);
  EXPECT_THROW(baseline_corrected(drift, dt, BaselineFit::velocity, 11), std::invalid_argument);
  EXPECT_THROW(baseline_corrected(std::vector(4, 1.0), dt, BaselineFit::velocity, 3), std::invalid_argument);
}

} // namespace
} // namespace tremolo::motion
