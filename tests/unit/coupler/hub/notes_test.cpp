#include "coupler/hub/notes.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tremolo::coupler {
namespace {

class NotesTold : public testing::Test {
protected:
  std::vector<std::string> told_;
  Clock::time_point start_ = Clock::now();
  Notes notes_{[this](const std::string& text) { told_.push_back(text); }, start_};
};

TEST_F(NotesTold, WordsOfOthersAreMadePrintable) {
  notes_.show("'left' says \x1b[2J");
  EXPECT_EQ(told_.back(), "'left' says \\x1b[2J");
}

TEST_F(NotesTold, OneConnectionIsToldOfFiveTimesInARow) {
  for (int i = 0; i < 10'000; ++i)
    notes_.show_of_stranger("one", "refused", start_);
  EXPECT_EQ(told_.size(), 5U);
  notes_.show_of_stranger("two", "somebody else", start_);
  ASSERT_EQ(told_.size(), 7U);
  EXPECT_EQ(told_[5], "9995 notes about strangers were left out");
  EXPECT_EQ(told_[6], "somebody else");
}

TEST_F(NotesTold, AFloodOfConnectionsIsTwentyNotesAndThenOneASecond) {
  for (int i = 0; i < 10'000; ++i)
    notes_.show_of_stranger(std::to_string(i), "refused", start_);
  EXPECT_EQ(told_.size(), 20U);
  notes_.show_of_stranger("x", "again", start_ + std::chrono::milliseconds(1100));
  EXPECT_EQ(told_.size(), 22U);
  EXPECT_EQ(told_[20], "9980 notes about strangers were left out");
  EXPECT_EQ(told_[21], "again");
  notes_.show_of_stranger("y", "once more", start_ + std::chrono::milliseconds(1200));
  EXPECT_EQ(told_.size(), 22U);
}

TEST_F(NotesTold, TheRunItselfIsAlwaysHeard) {
  for (int i = 0; i < 100; ++i)
    notes_.show("waits");
  EXPECT_EQ(told_.size(), 100U);
}

} // namespace
} // namespace tremolo::coupler
