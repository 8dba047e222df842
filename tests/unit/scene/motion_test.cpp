#include "scene/plan/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tremolo::scene {
namespace {

double largest_error(double dt) {
  // A smooth bump of velocity, exactly zero with its slope at both ends.
  const auto exact = [](double t) { return std::pow(std::sin(std::numbers::pi * t / 4.0), 4); };
  std::vector<double> samples;
  for (double t = 0.0; t < 4.0 + 0.5 * dt; t += dt)
    samples.push_back(exact(t));
  const auto motion = Motion::record(samples, dt);
  double largest = 0.0;
  for (double t = 0.2; t < 4.0; t += 0.0137) // after the rise of 0.1 s and the spline's ends
    largest = std::max(largest, std::abs(motion.velocity(t) - exact(t)));
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

TEST(Motion, RecordConvergesWithFourthOrder) {
  const double order = std::log2(largest_error(0.1) / largest_error(0.05));
  EXPECT_NEAR(order, 4.0, 0.3);
}

TEST(Motion, RecordStartsAndEndsAtRest) {
  const std::vector<double> samples(201, 1.0);
  const auto motion = Motion::record(samples, 0.01);
  EXPECT_EQ(motion.begin(), 0.0);
  EXPECT_NEAR(motion.end(), 3.0, 1e-12);
  EXPECT_EQ(motion.velocity(-1e-6), 0.0);
  EXPECT_EQ(motion.velocity(0.0), 0.0);
  EXPECT_NEAR(motion.velocity(0.05), 0.5, 1e-12);
  EXPECT_NEAR(motion.velocity(1.0), 1.0, 1e-9);
  EXPECT_NEAR(motion.velocity(2.5), 0.5, 1e-3);
  EXPECT_NEAR(motion.velocity(motion.end()), 0.0, 1e-12);
  EXPECT_EQ(motion.velocity(3.1), 0.0);
}

TEST(Motion, RecordRefusesWhatIsNoMotion) {
  EXPECT_THROW(Motion::record(std::vector<double>{1.0}, 0.01), std::invalid_argument);
  EXPECT_THROW(Motion::record(std::vector<double>{0.0, 1.0}, 0.0), std::invalid_argument);
  EXPECT_THROW(Motion::record(std::vector<double>{0.0, std::numeric_limits<double>::quiet_NaN()}, 0.01),
               std::invalid_argument);
}

} // namespace
} // namespace tremolo::scene
