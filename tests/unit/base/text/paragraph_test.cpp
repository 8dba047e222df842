#include "base/text/paragraph.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace tremolo {
namespace {

TEST(Paragraph, BreaksAtSpacesBeforeTheMargin) {
  std::string text = "x";
  for (std::size_t word = 1; word < 100; ++word) {
    text += ' ';
    text.append(1 + word % 9, 'x');
  }
  const std::string paragraph = wrapped(text);
  std::istringstream lines(paragraph);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 120U);
    EXPECT_NE(line.back(), ' ');
  }
  std::string joined = paragraph;
  for (char& c : joined)
    if (c == '\n')
      c = ' ';
  EXPECT_EQ(joined, text);
}

TEST(Paragraph, LeavesWhatFitsAndWhatCannotBeBroken) {
  EXPECT_EQ(wrapped("one line"), "one line");
  EXPECT_EQ(wrapped(""), "");
  const std::string word(200, 'x');
  EXPECT_EQ(wrapped(word), word);
}

} // namespace
} // namespace tremolo
