#include "coupler/hub/admission/case_difference.hpp"

#include <gtest/gtest.h>

namespace tremolo::coupler {
namespace {

constexpr const char* text =
    "title = \"box\"\n\n[mesh]\nsize = 0.5\nbox = [0, 1]\n\n[time]\norder = \"musl\"\n";

std::string changed(const std::string& old_part, const std::string& new_part) {
  std::string all = text;
  return all.replace(all.find(old_part), old_part.size(), new_part);
}

TEST(CaseDifference, EqualTextsHaveNone) {
  EXPECT_EQ(case_difference(text, text), "");
}

TEST(CaseDifference, KeyItsTableAndBothValuesAreTold) {
  EXPECT_EQ(case_difference(changed("size = 0.5", "size = 1.0"), text),
            "line 4, [mesh]: 'size = 1.0' against 'size = 0.5'");
  EXPECT_EQ(case_difference(changed("musl", "usl"), text),
            "line 8, [time]: 'order = \"usl\"' against 'order = \"musl\"'");
}

TEST(CaseDifference, MissingKeyIsTold) {
  EXPECT_EQ(case_difference(changed("size = 0.5\n", ""), text),
            "line 4, [mesh]: 'box = [0, 1]' against 'size = 0.5'");
  EXPECT_EQ(case_difference(changed("order = \"musl\"\n", ""), text),
            "line 8, [time]: '(end of the file)' against 'order = \"musl\"'");
}

TEST(CaseDifference, LastLineEndIsTold) {
  EXPECT_EQ(case_difference("a = 1", "a = 1\n"), "only the ends of the last lines differ");
}

} // namespace
} // namespace tremolo::coupler
