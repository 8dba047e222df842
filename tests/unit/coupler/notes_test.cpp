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
  notes_.tell("'left' says \x1b[2J");
  EXPECT_EQ(told_.back(), "'left' says \\x1b[2J");
}

TEST_F(NotesTold, AFloodOfStrangersIsTenNotesAndThenOneASecond) {
  for (int i = 0; i < 10'000; ++i)
    notes_.tell_of_stranger("refused", start_);
  EXPECT_EQ(told_.size(), 10U);
  notes_.tell_of_stranger("again", start_ + std::chrono::milliseconds(1100));
  EXPECT_EQ(told_.size(), 12U);
  EXPECT_EQ(told_[10], "9990 notes about strangers were left out");
  EXPECT_EQ(told_[11], "again");
  notes_.tell_of_stranger("once more", start_ + std::chrono::milliseconds(1200));
  EXPECT_EQ(told_.size(), 12U);
}

TEST_F(NotesTold, TheRunItselfIsAlwaysHeard) {
  for (int i = 0; i < 100; ++i)
    notes_.tell("waits");
  EXPECT_EQ(told_.size(), 100U);
}

} // namespace
} // namespace tremolo::coupler
