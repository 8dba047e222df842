// The rules of sections, each with a case that keeps it and one that breaks it, and the message.

#include "../section_case.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::string_view across = "from = [8.0, 1.0]\nto = [12.0, 1.0]";

std::string twin(std::string_view name) {
  return with_section(across) + "[[section]]\nname = \"" + std::string(name) +
         "\"\nstructure = \"block\"\nfrom = [8.0, 2.0]\nto = [12.0, 2.0]\n";
}

TEST(Rules, SectionsHaveNames) {
  EXPECT_THAT(errors_of(twin("top")), IsEmpty());
  EXPECT_THAT(errors_of(twin("foot")),
              ElementsAre(HasSubstr("[[section]] 'name' = \"foot\" is taken by the section in line 41")));
}

TEST(Rules, SectionsCutElasticStructures) {
  EXPECT_THAT(errors_of(with_section(across)), IsEmpty());
  EXPECT_THAT(
      errors_of(section_with("young = 20e6\npoisson = 0.2", "rigid = true")),
      ElementsAre(HasSubstr("[[section]] structure 'block' is rigid, and no stress is computed in it: "
                            "give it 'young' and 'poisson' in place of 'rigid'")));
}

TEST(Rules, SectionsGoThrough) {
  EXPECT_THAT(errors_of(with_section("from = [7.0, 0.5]\nto = [13.0, 2.0]")), IsEmpty());
  EXPECT_THAT(
      errors_of(with_section("from = [8.0, 5.0]\nto = [12.0, 5.0]")),
      ElementsAre(HasSubstr("[[section]] the line from [8, 5] to [12, 5] does not go through structure "
                            "'block': move its ends")));
  EXPECT_THAT(errors_of(with_section("from = [8.0, 1.0]\nto = [11.0, 1.0]")),
              ElementsAre(HasSubstr("the line from [8, 1] to [11, 1] ends within structure 'block', must go "
                                    "from one surface to the other: move its ends out of it")));
  EXPECT_THAT(errors_of(with_section("from = [9.0, 1.0]\nto = [9.0, 1.0]")),
              ElementsAre(HasSubstr("'from' and 'to' are the point [9, 1], must be apart")));
  EXPECT_THAT(errors_of(with_hole("from = [6.0, 4.0]\nto = [8.0, 4.0]")), IsEmpty());
  EXPECT_THAT(errors_of(with_hole("from = [6.0, 4.0]\nto = [14.0, 4.0]")),
              ElementsAre(HasSubstr("goes through structure 'block' more than once: give each part a "
                                    "[[section]] of its own")));
  EXPECT_THAT(errors_of(with_hole("ring = { centre = [10.0, 4.0], inner = 2.0, outer = 4.0 }")),
              ElementsAre(HasSubstr("ends within structure 'block'")));
}

TEST(Rules, SectionsHaveCells) {
  const auto warned = Contains(HasSubstr("the cut is 2 m long, 2 cells of 1 m: what bends needs about four "
                                         "cells over its thickness; take smaller cells, or a [[lining]]"));
  EXPECT_THAT(remarks_of(with_section(across)), Not(Contains(HasSubstr("the cut is"))));
  EXPECT_THAT(remarks_of(with_hole("from = [6.0, 4.0]\nto = [8.0, 4.0]")), warned);
  EXPECT_THAT(remarks_of(with_hole("ring = { centre = [10.0, 4.0], inner = 1.0, outer = 6.0 }")), warned);
}

} // namespace
} // namespace tremolo::scene::testing
