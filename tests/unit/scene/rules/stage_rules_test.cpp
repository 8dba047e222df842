// The list of stages: their names, and what a case says of each kind that has no test of its own.

#include "rule_cases.hpp"

#include "scene/plan/stages/stages.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string rest = "[[stage]]\nkind = \"rest\"\nduration_s = 100.0\n";

std::string heavy(const std::string& more = "") {
  return with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n" + more + "[[stage]]");
}

std::vector<std::string> names_of(const std::string& text) {
  std::vector<std::string> names;
  for (const PlannedStage& stage : stages(parse_case(text)))
    names.push_back(stage.name);
  return names;
}

TEST(Stages, HaveTheNameOfTheirKindOrOneOfTheirOwn) {
  EXPECT_THAT(names_of(heavy() + rest), ElementsAre("gravity", "shaking", "rest"));
  EXPECT_THAT(names_of(heavy("name = \"before\"\n") + rest + "name = \"ten minutes\"\n"),
              ElementsAre("before", "shaking", "ten minutes"));
}

TEST(Stages, HaveDifferentNames) {
  EXPECT_THAT(errors_of(plus(rest + "name = \"shaking\"\n")),
              ElementsAre("case.toml:34:8: [[stage]] the stage in line 29 has the name 'shaking' already: "
                          "give one of both another 'name'"));
  EXPECT_THAT(errors_of(plus(rest + "nam = \"slow\"\n")),
              ElementsAre(HasSubstr("unknown key 'nam', did you mean 'name'?")));
  EXPECT_THAT(errors_of(plus(rest + "name = \"gravity\"\n")), IsEmpty()); // there is none of that kind
}

TEST(Stages, AreListedWithWhatChangesAndHowLongTheyLast) {
  const std::string text =
      stages_text(parse_case(heavy() + rest + "time_factor = 1.0\nuntil_ratio = 0.01\n"));
  EXPECT_THAT(text, HasSubstr("1  gravity             gravity   weight of 9.81 m/s2"));
  EXPECT_THAT(text, HasSubstr("2  shaking             shaking   the motion enters; static tractions hold"));
  EXPECT_THAT(text, HasSubstr("100 s, from 2 s, or until no excess pore pressure ratio is above 0.01"));
}

} // namespace
} // namespace tremolo::scene::testing
