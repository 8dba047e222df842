#include "coupler/client/timeline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace tremolo::coupler {
namespace {

void sleep(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

double total(const TimelineReport& report) {
  double sum = 0.0;
  for (const auto& [activity, seconds] : report.activities)
    sum += report.seconds(activity);
  return sum;
}

TEST(Timeline, EverySecondBelongsToOneActivity) {
  const auto start = Clock::now();
  Timeline timeline(0.01);
  const double made = seconds_since(start);
  sleep(0.02);
  {
    const auto waiting = timeline.enter(waiting_for("right"));
    sleep(0.05);
    const auto within = timeline.enter(mapping);
    sleep(0.03);
  }
  const double least = seconds_since(start) - made;
  const TimelineReport report = timeline.report();
  const double most = seconds_since(start);
  EXPECT_GE(total(report), least);
  EXPECT_LE(total(report), most);
  EXPECT_GE(report.seconds(computing), 0.02);
  EXPECT_GE(report.seconds("waiting for right"), 0.05);
  EXPECT_GE(report.seconds(mapping), 0.03);
  EXPECT_EQ(report.seconds("waiting for left"), 0.0);
}

TEST(Timeline, ASliceHoldsNoMoreThanItsOwnTime) {
  Timeline timeline(0.004);
  for (int i = 0; i < 10; ++i) {
    const auto mapped = timeline.enter(mapping);
    sleep(0.003);
  }
  const TimelineReport report = timeline.report();
  for (std::size_t i = 0; i < 3; ++i) {
    double slice = 0.0;
    for (const auto& [activity, seconds] : report.activities)
      slice += i < seconds.size() ? seconds[i] : 0.0;
    EXPECT_NEAR(slice, report.slice, 1e-9) << "slice " << i;
  }
}

TEST(Timeline, ALongRunHasLongerSlicesNotMore) {
  Timeline timeline(1e-5);
  sleep(0.01);
  {
    const auto waiting = timeline.enter(waiting_for("left"));
    sleep(0.01);
  }
  const TimelineReport report = timeline.report();
  EXPECT_GE(report.slice, 0.02 / 256.0);
  for (const auto& [activity, seconds] : report.activities)
    EXPECT_LE(seconds.size(), 256U) << activity;
  EXPECT_GE(report.seconds("waiting for left"), 0.01);
  EXPECT_GE(total(report), 0.02);
}

TEST(Timeline, WhoWaitsForOneWhoWaitsForAThirdWaitsForTheThird) {
  TimelineReport domain{0.5, {{"computing", {0.1, 0.5}}, {"waiting for hub", {0.4, 0.0, 0.3, 0.2}}}};
  const TimelineReport hub{1.0, {{"waiting for right", {0.25, 0.4}}, {"mapping", {0.1, 0.1}}}};
  domain.resolve_waits("hub", hub);
  EXPECT_EQ(domain.slice, 1.0);
  EXPECT_THAT(domain.activities.at("computing"), testing::ElementsAre(testing::DoubleEq(0.6)));
  EXPECT_THAT(domain.activities.at("waiting for right"),
              testing::ElementsAre(testing::DoubleEq(0.25), testing::DoubleEq(0.4)));
  EXPECT_THAT(domain.activities.at("waiting for hub"),
              testing::ElementsAre(testing::DoubleNear(0.15, 1e-15), testing::DoubleNear(0.1, 1e-15)));
}

} // namespace
} // namespace tremolo::coupler
