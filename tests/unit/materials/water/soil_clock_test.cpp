#include "materials/water/soil_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo::materials {
namespace {

TEST(SoilClock, IsThatOfTheSimulationWithoutAFactor) {
  const SoilClock clock({{15.0}, {600.0, 1.0}});
  for (const double time : {0.0, 14.9, 15.0, 16.3, 615.1}) {
    EXPECT_EQ(clock.time_of_soil(time), time);
    EXPECT_EQ(clock.simulated_time(time), time);
    EXPECT_EQ(clock.speed(time), 1.0);
  }
}

TEST(SoilClock, IsTheIntegralOfItsSpeed) {
  const SoilClock clock({{15.0}, {3600.0, 100.0}});
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

TEST(SoilClock, ComesBackFromATimeOfTheSoil) {
  for (const double factor : {1.5, 30.0, 1e4}) {
    const SoilClock clock({{15.0}, {3600.0, factor}});
    for (const double time : {3.0, 15.0, 15.5, 17.0, 17.5, 40.0})
      EXPECT_NEAR(clock.simulated_time(clock.time_of_soil(time)), time, 1e-9) << factor;
  }
}

TEST(SoilClock, HasNoRestsByItself) {
  const SoilClock clock;
  EXPECT_FALSE(clock.rests(1.0));
  EXPECT_FALSE(clock.has_rested(1.0));
  EXPECT_EQ(clock.speed(1.0), 1.0);
  EXPECT_EQ(clock.time_of_soil(1.5), 1.5);
}

/// Main shock, rest, aftershock, and a rest in two parts.
SoilClock of_two_shocks() {
  return SoilClock({{15.0}, {600.0, 20.0}, {10.0}, {5.0, 1.0}, {400.0, 50.0}});
}

TEST(SoilClock, ShakesAndRestsInTurn) {
  const SoilClock clock = of_two_shocks();
  const double aftershock = clock.simulated_time(615.0 + 1e-9), end = clock.simulated_time(625.0 + 1e-9);
  EXPECT_NEAR(end - aftershock, 10.0, 1e-6);
  EXPECT_FALSE(clock.rests(14.9));
  EXPECT_FALSE(clock.has_rested(14.9));
  EXPECT_TRUE(clock.rests(15.0));
  EXPECT_TRUE(clock.rests(aftershock - 0.1));
  EXPECT_FALSE(clock.rests(aftershock + 0.1));
  EXPECT_TRUE(clock.has_rested(aftershock + 0.1));
  EXPECT_EQ(clock.speed(aftershock + 0.1), 1.0);
  EXPECT_TRUE(clock.rests(end + 0.1));
  EXPECT_EQ(clock.speed(end + 4.9), 1.0); // the part that is not sped up
  EXPECT_GT(clock.speed(end + 5.1), 1.0);
}

TEST(SoilClock, SlowsDownBeforeTheNextStage) {
  const SoilClock clock = of_two_shocks();
  const double aftershock = clock.simulated_time(615.0 + 1e-9);
  EXPECT_NEAR(clock.speed(aftershock - 1e-6), 1.0, 1e-5);
  EXPECT_NEAR(clock.speed(aftershock - 1.0), std::sqrt(20.0), 1e-5);
  EXPECT_NEAR(clock.speed(0.5 * (15.0 + aftershock)), 20.0, 1e-12);
  double integral = 0.0; // by the midpoint rule, over all stages
  constexpr double dt = 1e-3;
  for (int i = 0; i < 80000; ++i) {
    integral += dt * clock.speed((i + 0.5) * dt);
    ASSERT_NEAR(clock.time_of_soil((i + 1) * dt), integral, 2e-2) << i; // a step across a kink of N
  }
  for (double time = 0.25; time < 80.0; time += 0.25)
    EXPECT_NEAR(clock.simulated_time(clock.time_of_soil(time)), time, 1e-9);
}

/// 8 s of the soil's time are too short to reach a factor of 1000 and come back.
TEST(SoilClock, TurnsBackInAShortRest) {
  const SoilClock clock({{2.0}, {8.0, 1000.0}, {3.0}});
  const double to = clock.simulated_time(10.0 + 1e-9);
  const double rate = std::log(1000.0) / SoilClock::rise, fastest = 1.0 + 4.0 * rate;
  EXPECT_NEAR(to - 2.0, 2.0 * std::log(fastest) / rate, 1e-6);
  EXPECT_NEAR(clock.speed(0.5 * (2.0 + to)), fastest, 1e-6);
  EXPECT_NEAR(clock.time_of_soil(0.5 * (2.0 + to)), 6.0, 1e-6);
  EXPECT_NEAR(clock.time_of_soil(to + 1.0), 11.0, 1e-6);
}

} // namespace
} // namespace tremolo::materials
