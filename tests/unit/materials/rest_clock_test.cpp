#include "materials/water/rest_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo::materials {
namespace {

TEST(RestClock, IsThatOfTheSimulationWithoutAFactor) {
  const RestClock clock{15.0};
  for (const double time : {0.0, 14.9, 15.0, 16.3, 615.1}) {
    EXPECT_EQ(clock.time_of_soil(time), time);
    EXPECT_EQ(clock.simulated_time(time), time);
    EXPECT_EQ(clock.speed(time), 1.0);
  }
}

TEST(RestClock, IsTheIntegralOfItsSpeed) {
  const RestClock clock{15.0, 100.0};
  EXPECT_EQ(clock.time_of_soil(12.0), 12.0);
  EXPECT_EQ(clock.speed(15.0), 1.0);
  EXPECT_NEAR(clock.speed(16.0), 10.0, 1e-12); // half way
  EXPECT_NEAR(clock.speed(40.0), 100.0, 1e-12);
  double integral = 15.0; // by the midpoint rule
  constexpr double dt = 1e-4;
  for (int i = 0; i < 50000; ++i) {
    integral += dt * clock.speed(15.0 + (i + 0.5) * dt);
    if (i % 10000 == 9999) {
      EXPECT_NEAR(clock.time_of_soil(15.0 + (i + 1) * dt) / integral, 1.0, 1e-7) << i;
    }
  }
}

TEST(RestClock, ComesBackFromATimeOfTheSoil) {
  for (const double factor : {1.5, 30.0, 1e4}) {
    const RestClock clock{15.0, factor};
    for (const double time : {3.0, 15.0, 15.5, 17.0, 17.5, 40.0})
      EXPECT_NEAR(clock.simulated_time(clock.time_of_soil(time)), time, 1e-9) << factor;
  }
}

} // namespace
} // namespace tremolo::materials
