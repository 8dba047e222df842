#include "scene/plan/wave/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace tremolo::scene {
namespace {

/// A packet of waves, its velocity and its acceleration: centre 3 s, its spectrum below 1e-7 half a hertz
/// away from its frequency (Hz).
class Packet {
public:
  explicit Packet(double frequency) : omega_(2.0 * std::numbers::pi * frequency) {}

  double velocity(double t) const { return envelope(t) * std::sin(omega_ * (t - 3.0)); }
  double acceleration(double t) const {
    return envelope(t) * (omega_ * std::cos(omega_ * (t - 3.0)) -
                          (t - 3.0) / (width * width) * std::sin(omega_ * (t - 3.0)));
  }

private:
  static constexpr double width = 0.5; // s
  static double envelope(double t) { return std::exp(-0.5 * std::pow((t - 3.0) / width, 2)); }
  double omega_;
};

constexpr double dt = 0.02; // s; the Nyquist frequency is 25 Hz

std::vector<double> samples_of(const std::function<double(double)>& function) {
  std::vector<double> samples;
  for (std::size_t i = 0; i <= 300; ++i)
    samples.push_back(function(static_cast<double>(i) * dt));
  return samples;
}

/// Largest difference from the packet's velocity, anywhere between the samples.
double largest_error(const Motion& motion, const Packet& packet) {
  double largest = 0.0;
  for (double t = 0.2; t < 6.0; t += 0.00137)
    largest = std::max(largest, std::abs(motion.velocity(t) - packet.velocity(t)));
  return largest;
}

TEST(Motion, RickerIsTheFormula) {
  const auto motion = Motion::ricker({.frequency = 3.0, .time = 1.0, .velocity = 0.1});
  EXPECT_DOUBLE_EQ(motion.velocity(1.0), 0.1);
  // Zeros at a = 1/2, the troughs -2 V exp(-3/2) at a = 3/2.
  EXPECT_NEAR(motion.velocity(1.0 + std::sqrt(0.5) / (3.0 * std::numbers::pi)), 0.0, 1e-15);
  EXPECT_NEAR(motion.velocity(1.0 - std::sqrt(1.5) / (3.0 * std::numbers::pi)), -0.2 * std::exp(-1.5), 1e-15);
  EXPECT_LT(std::abs(motion.velocity(motion.begin())), 1e-18);
  EXPECT_EQ(motion.velocity(motion.end() + 1e-9), 0.0);
  EXPECT_THROW(Motion::ricker({.frequency = 0.0, .time = 1.0, .velocity = 0.1}), std::invalid_argument);
}

// At 20 Hz a period has two and a half samples: the trapezoidal rule errs there by 45 %, a spline by 30 %.
TEST(Motion, RecordsKeepAllFrequenciesBelowTheirOwn) {
  for (const double frequency : {2.0, 10.0, 20.0}) {
    const Packet packet(frequency);
    const auto velocity = Motion::of_velocity(samples_of([&](double t) { return packet.velocity(t); }), dt);
    const auto acceleration =
        Motion::of_acceleration(samples_of([&](double t) { return packet.acceleration(t); }), dt);
    EXPECT_LT(largest_error(velocity, packet), 1e-4) << frequency;
    EXPECT_LT(largest_error(acceleration, packet), 1e-4) << frequency;
  }
}

TEST(Motion, AccelerationsEndAtRest) {
  // 1 m/s2 over 1 s leaves 1 m/s, which falls to zero within the second after.
  const auto motion = Motion::of_acceleration(std::vector<double>(101, 1.0), 0.01);
  EXPECT_NEAR(motion.velocity(0.5), 0.505,
              1e-3); // sample i stands for the time from i - 1/2 to i + 1/2 steps
  EXPECT_NEAR(motion.velocity(1.5), 0.505, 1e-3);
  EXPECT_NEAR(motion.velocity(motion.begin()), 0.0, 1e-15);
  EXPECT_NEAR(motion.velocity(motion.end()), 0.0, 1e-15);
  EXPECT_NEAR(motion.begin(), -0.16, 1e-12);
  EXPECT_NEAR(motion.end(), 2.0, 1e-12);
}

TEST(Motion, RecordStartsAndEndsAtRest) {
  const std::vector<double> samples(201, 1.0);
  const auto motion = Motion::of_velocity(samples, 0.01);
  EXPECT_NEAR(motion.begin(), -0.16, 1e-12);
  EXPECT_NEAR(motion.end(), 3.0, 1e-12);
  EXPECT_EQ(motion.velocity(-0.161), 0.0);
  EXPECT_NEAR(motion.velocity(0.0), 0.0, 1e-12);
  EXPECT_NEAR(motion.velocity(0.05), 0.5, 1e-12);
  EXPECT_NEAR(motion.velocity(1.0), 1.0, 1e-9);
  EXPECT_NEAR(motion.velocity(2.5), 0.5, 1e-3);
  EXPECT_NEAR(motion.velocity(motion.end()), 0.0, 1e-12);
  EXPECT_EQ(motion.velocity(3.1), 0.0);
}

TEST(Motion, RecordRefusesWhatIsNoMotion) {
  EXPECT_THROW(Motion::of_velocity(std::vector<double>{1.0}, 0.01), std::invalid_argument);
  EXPECT_THROW(Motion::of_velocity(std::vector<double>{0.0, 1.0}, 0.0), std::invalid_argument);
  EXPECT_THROW(Motion::of_velocity(std::vector<double>{0.0, std::numeric_limits<double>::quiet_NaN()}, 0.01),
               std::invalid_argument);
}

} // namespace
} // namespace tremolo::scene
