#include "coupler/mapping/pace.hpp"

#include <gtest/gtest.h>

namespace tremolo::coupler {
namespace {

using std::chrono::seconds;

/// A participant that gets on at these intervals, s.
Pace pace_of(const std::vector<int>& intervals) {
  Pace pace;
  Clock::time_point now{};
  pace.asked(now);
  for (const int interval : intervals)
    pace.advanced(now += seconds(interval));
  return pace;
}

TEST(Pace, DeadlineIsTheLeastPatience) {
  EXPECT_EQ(Pace{}.patience(60.0), 60.0);
  EXPECT_EQ(pace_of({1, 1, 1, 1, 1, 1, 1, 1}).patience(60.0), 60.0);
}

TEST(Pace, LongStepsEarnTwentyTimesTheirMedian) {
  EXPECT_DOUBLE_EQ(pace_of({10, 10, 10, 10, 10, 10, 10}).patience(60.0), 200.0);
}

TEST(Pace, OnePauseDoesNotMoveTheMedian) {
  EXPECT_DOUBLE_EQ(pace_of({10, 10, 10, 500, 10, 10, 10}).patience(60.0), 200.0);
}

TEST(Pace, FirstFewStepsEarnNothing) {
  EXPECT_EQ(pace_of({100, 100, 100}).patience(60.0), 60.0);
}

TEST(Pace, OldStepsAreForgotten) {
  std::vector<int> intervals(40, 100);
  intervals.insert(intervals.end(), 31, 1);
  EXPECT_EQ(pace_of(intervals).patience(60.0), 60.0);
}

TEST(Pace, IdleTimeBeforeTheQuestionDoesNotCount) {
  Pace pace;
  Clock::time_point now{};
  pace.asked(now);
  EXPECT_EQ(pace.silence(now + seconds(3)), 3.0);
  pace.asked(now + seconds(100));
  EXPECT_EQ(pace.silence(now + seconds(101)), 1.0);
}

} // namespace
} // namespace tremolo::coupler
