#include "base/words.hpp"

#include <gtest/gtest.h>

namespace elsewhere {

enum class Colour { red, green };
constexpr auto words(Colour) {
  return tremolo::word_table<Colour>({{Colour::green, "Green"}, {Colour::red, "Red"}});
}

enum class Wordless { one };

} // namespace elsewhere

namespace tremolo {
namespace {

using elsewhere::Colour;

static_assert(Worded<Colour>);
static_assert(!Worded<elsewhere::Wordless>);
static_assert(!Worded<int>);

TEST(Words, BelongToAnEnumerationOfAnyNamespace) {
  EXPECT_EQ(name(Colour::red), "Red");
  EXPECT_EQ(value_named<Colour>("Red"), Colour::red);
  EXPECT_EQ(value_named<Colour>("red"), std::nullopt);
}

TEST(Words, AreListedInTheOrderOfTheTable) {
  EXPECT_EQ(all_words<Colour>(), (std::vector<std::string_view>{"Green", "Red"}));
}

} // namespace
} // namespace tremolo
