#include "motion/plausible.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tremolo::motion {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Doubts, NoneOfAStrongMotion) {
  EXPECT_THAT(doubts({.unit = Unit::g, .dt = 0.1, .samples = {0.0, 1.9, -1.9, 0.0}}), IsEmpty());
}

TEST(Doubts, PgaWithTheUnitsThatWouldDo) {
  EXPECT_THAT(doubts({.unit = Unit::g, .dt = 0.001, .samples = {0.0, 300.0, -300.0, 0.0}}),
              ElementsAre(AllOf(HasSubstr("PGA 300 g, above 2 g"), HasSubstr("0.31 g in cm/s2"),
                                HasSubstr("0.3 g in 0.001 g"))));
}

TEST(Doubts, PgvFromADriftIsTheBaseline) {
  // 1 m/s2 for 10 s integrates to 10 m/s.
  EXPECT_THAT(doubts({.unit = Unit::m_s2, .dt = 0.1, .samples = std::vector(101, 1.0)}),
              ElementsAre(AllOf(HasSubstr("PGV 10 m/s, above 5 m/s"), HasSubstr("offset of the baseline"))));
}

TEST(Doubts, AStepLikeANumberOfSteps) {
  EXPECT_THAT(doubts({.unit = Unit::m_s2, .dt = 1.0, .samples = {0.0, 0.1, -0.1, 0.0}}),
              ElementsAre(AllOf(HasSubstr("a step of 1 s, above 0.1 s"), HasSubstr("numbers of steps"))));
}

TEST(Doubts, OfTheReaderComeFirst) {
  Record record{.unit = Unit::m_s2, .dt = 0.01, .samples = {0.0, 0.1}};
  record.origin.doubts = {"a peak"};
  EXPECT_THAT(doubts(record), ElementsAre("a peak"));
}

} // namespace
} // namespace tremolo::motion
