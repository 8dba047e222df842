// Sections: their keys, where they go through a structure, and what the plan says of them.

#include "section_case.hpp"

#include "scene/plan/plan.hpp"
#include "scene/plan/section/section_cuts.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Section, IsRead) {
  const Case scene = parse_case(with_section("from = [7.0, 1.0]\nto = [13.0, 1.0]"));
  const Section& section = scene.sections.at(0);
  EXPECT_EQ(section.name, "foot");
  EXPECT_EQ(section.structure, 0U);
  EXPECT_FALSE(section.centre);
  const std::vector<SectionCut> cuts = cuts_of(scene, section);
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_DOUBLE_EQ(cuts[0].line.from.x, 8.0); // what lies outside of the block is no part of the cut
  EXPECT_DOUBLE_EQ(cuts[0].line.to.x, 12.0);
  EXPECT_DOUBLE_EQ(cuts[0].thickness(), 4.0);
}

TEST(Section, MayBeARing) {
  const Case scene =
      parse_case(with_hole("ring = { centre = [10.0, 4.0], inner = 1.0, outer = 6.0, count = 8 }"));
  const Section& section = scene.sections.at(0);
  ASSERT_EQ(section.lines.size(), 8U);
  EXPECT_EQ(section.centre->y, 4.0);
  const std::vector<SectionCut> cuts = cuts_of(scene, section);
  EXPECT_NEAR(cuts[0].line.from.x, 12.0, 1e-12); // to the right
  EXPECT_NEAR(cuts[0].line.to.x, 14.0, 1e-12);
  EXPECT_NEAR(cuts[2].line.from.y, 6.0, 1e-12); // then up
  EXPECT_NEAR(cuts[2].line.to.y, 8.0, 1e-12);
  EXPECT_NEAR(cuts[1].thickness(), 2.0 * std::sqrt(2.0), 1e-12);
}

TEST(Section, WrongKeysAreRefusedWhereTheyStand) {
  EXPECT_THAT(errors_of(with_section("")),
              ElementsAre(HasSubstr("[[section]] missing 'from' and 'to' of a cut, or 'ring'")));
  EXPECT_THAT(errors_of(with_section("from = [7.0, 1.0]")),
              ElementsAre(HasSubstr("[[section]] missing 'to': 'from' needs it")));
  EXPECT_THAT(
      errors_of(with_section("from = [7.0, 1.0]\nring = { centre = [10.0, 2.0], inner = 1.0, outer = 6.0 }")),
      ElementsAre(HasSubstr("[[section]] 'from' and 'to' exclude 'ring': remove one or the other")));
  EXPECT_THAT(errors_of(with_hole("ring = { centre = [10.0, 4.0], inner = 6.0, outer = 6.0 }")),
              ElementsAre(HasSubstr("'inner' = 6 m is out of range, must be below 'outer' = 6 m")));
  EXPECT_THAT(errors_of(with_hole("ring = { centre = [10.0, 4.0], inner = 1.0, outer = 6.0, count = 2 }")),
              ElementsAre(HasSubstr("'count' = 2 is out of range")));
  EXPECT_THAT(errors_of(section_with("structure = \"block\"", "structure = \"blok\"")),
              ElementsAre(HasSubstr("[[section]] structure 'blok' is not defined, did you mean 'block'?")));
}

TEST(Section, IsInThePlan) {
  const Case scene = parse_case(with_section("from = [7.0, 1.0]\nto = [13.0, 1.0]"));
  const Plan made = plan(scene);
  EXPECT_THAT(explain(scene, made), HasSubstr("foot              cut through 'block', 4 m, 4 cells of 1 m"));
  const auto json = nlohmann::json::parse(to_json(scene, made));
  EXPECT_EQ(json["sections"][0]["structure"], "block");
  EXPECT_DOUBLE_EQ(json["sections"][0]["thickness_m"][0], 4.0);
  EXPECT_GT(made.output_bytes, plan(parse_case(elastic_block())).output_bytes);
}

} // namespace
} // namespace tremolo::scene::testing
