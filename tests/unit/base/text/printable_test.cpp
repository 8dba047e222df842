#include "base/text/printable.hpp"

#include <gtest/gtest.h>

namespace tremolo {
namespace {

TEST(Printable, OrdinaryTextStaysAsItIs) {
  const std::string text = "σ' = 100 kPa\n\t'left': 水 🌊";
  EXPECT_EQ(printable(text), text);
}

TEST(Printable, ControlCharactersAreShownNotObeyed) {
  EXPECT_EQ(printable("\x1b[31mred\r\a\x7f"), "\\x1b[31mred\\x0d\\x07\\x7f");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\xc2\\x9b2J"); // CSI of ECMA-48 in one character
}

TEST(Printable, BytesThatAreNoUtf8AreShownAsBytes) {
  EXPECT_EQ(printable("caf\xe9"), "caf\\xe9");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");                   // overlong
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");          // a surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80"); // beyond U+10FFFF
  EXPECT_EQ(printable("\xe6\xb0"), "\\xe6\\xb0");                   // cut
}

TEST(Printable, LongTextIsCutAndSaysSo) {
  EXPECT_EQ(printable("abcdef", 6), "abcdef");
  EXPECT_EQ(printable("abcdefg", 4), "abcd ... (3 bytes more)");
}

TEST(Printable, ALineStaysOne) {
  EXPECT_EQ(printable_line("expected 'inf', saw 'i\n'"), "expected 'inf', saw 'i\\n'");
  EXPECT_TRUE(is_printable_line(std::string(10000, 'a')));
  EXPECT_FALSE(is_printable_line("a\n"));
  EXPECT_FALSE(is_printable_line("a\x1b[31m"));
}

} // namespace
} // namespace tremolo
