// A record with baseline error: an offset and a drift are added to a clean motion. The error is small beside
// the PGA and ruins the velocity; it is reported with its number, and the correction finds the clean velocity
// again.

#include "base/samples.hpp"
#include "motion/measures.hpp"
#include "motion/mend/process.hpp"
#include "motion/read/read.hpp"
#include "motion/record.hpp"
#include "tests/support/hard_case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::motion {
namespace {

constexpr double dt = 0.01;
constexpr double duration = 40.0;

double time_of(std::size_t i) {
  return static_cast<double>(i) * dt;
}

/// A velocity of bursts of 1.5 to 3 Hz, at rest at both ends; the acceleration is its slope.
std::vector<double> clean_velocity() {
  std::vector<double> v(4001);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double t = time_of(i);
    v[i] = 0.2 * std::exp(-std::pow((t - 12.0) / 4.0, 2)) * std::sin(2.0 * std::numbers::pi * 1.5 * t) +
           0.1 * std::exp(-std::pow((t - 22.0) / 5.0, 2)) * std::sin(2.0 * std::numbers::pi * 3.0 * t);
  }
  return v;
}

class HardCase19Drift : public ::testing::Test {
protected:
  HardCase19Drift() {
    for (std::size_t i = 0; i < spoilt.size(); ++i)
      spoilt[i] += offset + drift * time_of(i);
  }

  /// Largest difference of the velocity from the clean one.
  double velocity_error(std::span<const double> acceleration) const {
    const auto v = integrate(acceleration, dt);
    double largest = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i)
      largest = std::max(largest, std::abs(v[i] - velocity[i]));
    return largest;
  }

  double offset = 0.01; // m/s2, 0.5 % of the PGA
  double drift = -2e-4; // m/s3
  std::vector<double> velocity = clean_velocity();
  std::vector<double> spoilt = differentiate(velocity, dt);
};

TEST_F(HardCase19Drift, IsReportedWithItsNumber) {
  const auto m = measures(spoilt, dt);
  const double residual = offset * duration + 0.5 * drift * duration * duration; // 0.24 m/s
  test_support::bounded("error of the residual velocity that is reported",
                        std::abs(m.residual_velocity - residual), 1e-4, "m/s");
  const auto warning = residual_warning(m);
  ASSERT_TRUE(warning);
  EXPECT_TRUE(warning->starts_with(fmt::format("residual velocity {:.4g} m/s", m.residual_velocity)))
      << *warning;
  EXPECT_GT(velocity_error(spoilt), 0.9 * residual);
}

TEST_F(HardCase19Drift, CorrectionFindsTheCleanVelocity) {
  for (const auto& [fit, degree] : {std::pair{BaselineFit::velocity, 2}, {BaselineFit::displacement, 3}}) {
    const auto corrected = baseline_corrected(spoilt, dt, fit, degree);
    test_support::bounded("error of the corrected velocity over its peak",
                          velocity_error(corrected) / peak(velocity), 0.005);
    EXPECT_FALSE(residual_warning(measures(corrected, dt))) << degree;
    EXPECT_NEAR(measures(corrected, dt).residual_velocity, 0.0, 1e-12) << degree;
  }
}

TEST_F(HardCase19Drift, AHighPassLeavesNoDriftEither) {
  const auto tapered_motion = tapered(spoilt, dt, 2.0, 2.0);
  const auto filtered = band_passed(tapered_motion, dt, {.low = 0.1, .high = 0.0, .order = 4});
  EXPECT_LT(velocity_error(filtered), 0.05 * peak(velocity));
}

TEST(Extremes, AStepFreeSignalKeepsItsPeakWhenItIsResampled) {
  // Noise up to the Nyquist frequency is the hardest input: no value exceeds the peak by more than the sum of
  // the weights allows, and the record comes back at its own samples.
  std::vector<double> x(3000);
  unsigned state = 1;
  for (double& value : x) {
    state = state * 1664525U + 1013904223U;
    value = static_cast<double>(state) / 4294967296.0 - 0.5;
  }
  const auto fine = resampled(x, 0.01, 0.0025);
  for (std::size_t i = 0; i < x.size(); ++i)
    ASSERT_NEAR(fine[4 * i], x[i], 1e-12) << i;
  EXPECT_LT(peak(fine), 3.0 * peak(x));
}

TEST(Extremes, AMillionSamplesAreProcessed) {
  std::vector<double> x(1000000);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = std::sin(0.01 * static_cast<double>(i));
  const auto y = band_passed(baseline_corrected(x, 1e-4, BaselineFit::displacement, 10), 1e-4,
                             {.low = 0.05, .high = 100.0, .order = 10});
  EXPECT_TRUE(std::isfinite(peak(y)));
  EXPECT_LT(peak(y), 2.0);
}

} // namespace
} // namespace tremolo::motion
