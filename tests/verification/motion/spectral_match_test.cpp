// A motion brought to a target spectrum, judged by oscillators at periods of their own.

#include "motion/make/synthesis.hpp"
#include "motion/mend/spectral_match.hpp"
#include "motion/record.hpp"
#include "motion/spectra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo::motion {
namespace {

constexpr double dt = 0.01;

/// Noise under an envelope, m/s2, which begins and ends at rest.
std::vector<double> noise(std::uint32_t seed) {
  auto samples = white_noise(seed, 3000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) * dt;
    samples[i] *=
        std::pow(t / 4.0, 2) * std::exp(2.0 - t / 2.0) * std::pow(std::sin(3.14159265 * t / 30.0), 2);
  }
  return samples;
}

/// A design spectrum: rising to a plateau, then falling with the period and with its square.
TargetSpectrum design(double peak_ground) {
  TargetSpectrum target;
  for (double period = 0.1; period < 4.01; period *= 1.07) {
    target.periods.push_back(period);
    target.acceleration.push_back(peak_ground * (period < 0.15  ? 1.0 + period / 0.15 * 1.5
                                                 : period < 0.5 ? 2.5
                                                 : period < 2.0 ? 1.25 / period
                                                                : 2.5 / (period * period)));
  }
  return target;
}

double worst_misfit(const std::vector<double>& acceleration, const TargetSpectrum& target) {
  double worst = 0.0;
  const auto periods = spaced_periods(target.periods.front(), target.periods.back(), 397);
  for (const auto& one : response_spectrum(acceleration, dt, periods, target.damping))
    worst = std::max(
        worst, std::abs(one.acceleration / target.at(std::min(one.period, target.periods.back())) - 1.0));
  return worst;
}

TEST(SpectralMatching, BringsNoiseToADesignSpectrum) {
  const auto target = design(2.0);
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const auto result = spectrally_matched(noise(seed), dt, target);
    EXPECT_GT(result.before, 0.3) << "noise has another spectrum";
    EXPECT_LE(result.after, 0.05);
    EXPECT_LT(worst_misfit(result.acceleration, target), 0.1) << "between the periods that were matched";
  }
}

TEST(SpectralMatching, LeavesFinalVelocityAndDisplacement) {
  const auto before = noise(4);
  const auto result = spectrally_matched(before, dt, design(2.0));
  // The scaled record is that of a target far from which no step leads.
  const auto scaled = spectrally_matched(before, dt, design(2.0), {.steps = 0});
  const auto ends = [](const std::vector<double>& a) {
    double velocity = 0.0;
    double displacement = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      velocity += a[i] * dt;
      displacement += a[i] * dt * dt * static_cast<double>(a.size() - 1 - i);
    }
    return std::pair(velocity, displacement);
  };
  const auto [velocity, displacement] = ends(result.acceleration);
  const auto [scaled_velocity, scaled_displacement] = ends(scaled.acceleration);
  EXPECT_NEAR(velocity, scaled_velocity, 1e-9);
  EXPECT_NEAR(displacement, scaled_displacement, 1e-8);
}

TEST(SpectralMatching, LeavesAMotionThatHasTheSpectrum) {
  const auto before = noise(5);
  TargetSpectrum own;
  for (const auto& one : response_spectrum(before, dt, spaced_periods(0.1, 4.0, 200), 0.05)) {
    own.periods.push_back(one.period);
    own.acceleration.push_back(one.acceleration);
  }
  const auto result = spectrally_matched(before, dt, own);
  EXPECT_EQ(result.steps, 0);
  EXPECT_LT(result.after, 0.05);
  for (std::size_t i = 0; i < before.size(); ++i)
    ASSERT_NEAR(result.acceleration[i], before[i], 0.01 * 2.0);
}

TEST(SpectralMatching, FollowsTheDampingOfTheTarget) {
  auto target = design(1.5);
  target.damping = 0.2;
  const auto result = spectrally_matched(noise(1), dt, target);
  EXPECT_LT(worst_misfit(result.acceleration, target), 0.06);
}

TEST(SpectralMatching, RefusesWhatCannotBeMatched) {
  const auto motion = noise(7);
  auto early = design(2.0);
  early.periods.front() = 0.02;
  EXPECT_THROW(spectrally_matched(motion, dt, early), std::invalid_argument);
  auto late = design(2.0);
  late.periods.back() = 20.0;
  EXPECT_THROW(spectrally_matched(motion, dt, late), std::invalid_argument);
  auto negative = design(2.0);
  negative.acceleration[3] = -1.0;
  EXPECT_THROW(spectrally_matched(motion, dt, negative), std::invalid_argument);
  EXPECT_THROW(spectrally_matched(std::vector<double>(3000, 0.0), dt, design(2.0)), std::invalid_argument);
  auto damped = design(2.0);
  damped.damping = 0.0;
  EXPECT_THROW(spectrally_matched(motion, dt, damped), std::invalid_argument);
}

} // namespace
} // namespace tremolo::motion
