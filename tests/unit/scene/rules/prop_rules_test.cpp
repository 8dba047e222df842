// The rules of props, each with a case that keeps it and one that breaks it, and the message.

#include "../prop_case.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string stage(std::string_view keys) {
  return "[[stage]]\nkind = \"construction\"\n" + std::string(keys) + "\n";
}

std::string in_stages(const std::string& stages, const std::string& text = with_prop()) {
  return with("[[stage]]\nkind = \"shaking\"", stages + "[[stage]]\nkind = \"shaking\"", text);
}

TEST(Rules, PropsHaveNames) {
  const std::string second = "[[prop]]\nname = \"NAME\"\nfrom = { structure = \"block\", at = [12.0, 2.0] }\n"
                             "to = { at = [16.0, -3.0] }\nstiffness = 2e6\n";
  EXPECT_THAT(errors_of(with_prop() + with("NAME", "other", second)), IsEmpty());
  EXPECT_THAT(errors_of(with_prop() + with("NAME", "anchor", second)),
              ElementsAre(HasSubstr("[[prop]] 'name' = \"anchor\" is taken by the prop in line")));
  EXPECT_THAT(errors_of(with_prop() + with("NAME", "a/b", second)),
              ElementsAre(HasSubstr("names a table in the results")));
}

TEST(Rules, PropsAreFastened) {
  EXPECT_THAT(errors_of(with_prop()), IsEmpty());
  EXPECT_THAT(errors_of(prop_with("at = [8.0, 2.0]", "at = [7.5, 2.0]")),
              ElementsAre(HasSubstr("'at' [7.5, 2] lies outside structure 'block', to which the prop is "
                                    "fastened")));
  EXPECT_THAT(errors_of(prop_with("at = [4.0, -3.0]", "at = [4.0, 3.0]")),
              ElementsAre(HasSubstr("'at' [4, 3] lies in no soil while the prop 'anchor' stands: move it, or "
                                    "name a structure")));
  EXPECT_THAT(errors_of(prop_with("at = [4.0, -3.0]", "at = [10.0, 1.0]")),
              ElementsAre(HasSubstr("'at' [10, 1] lies in structure 'block': say structure = \"block\"")));
  EXPECT_THAT(
      errors_of(prop_with("structure = \"block\", at = [8.0, 2.0]", "at = [8.0, -2.0]")),
      ElementsAre(HasSubstr("both ends of the prop 'anchor' lie in the ground: one must be fastened to "
                            "a structure")));
  EXPECT_THAT(
      errors_of(prop_with("to = { at = [4.0, -3.0] }", "to = { structure = \"block\", at = [9.0, 1.0] }")),
      ElementsAre(HasSubstr("both ends of the prop 'anchor' are fastened to the structure 'block'")));
}

TEST(Rules, PropsAreFastenedInEveryStage) {
  EXPECT_THAT(errors_of(in_stages(stage("name = \"build\"\nplace = [\"block\"]") +
                                  stage("name = \"tie\"\nplace = [\"anchor\"]"))),
              IsEmpty());
  EXPECT_THAT(errors_of(in_stages(stage("name = \"build\"\nplace = [\"block\"]"))),
              Contains(HasSubstr("the structure 'block' does not stand all the time that the prop 'anchor' "
                                 "does")));
}

TEST(Rules, PropsBearTheirPrestress) {
  const auto stressed = [](std::string_view more) {
    return prop_with("stiffness = 2e6", "stiffness = 2e6\nprestress = 1e5\n" + std::string(more));
  };
  EXPECT_THAT(errors_of(stressed("bears = \"tension\"\nyield = 2e5")), IsEmpty());
  EXPECT_THAT(
      errors_of(stressed("bears = \"compression\"")),
      ElementsAre(HasSubstr("'prestress' = 100000 N/m is tension, but the prop 'anchor' bears compression "
                            "alone: tension is positive")));
  EXPECT_THAT(errors_of(stressed("yield = 5e4")),
              ElementsAre(HasSubstr("'prestress' = 100000 N/m is over 'yield' = 50000 N/m")));
}

TEST(Rules, PropsSuitCase) {
  const std::string stressed = prop_with("stiffness = 2e6", "stiffness = 2e6\nprestress = 1e5");
  EXPECT_THAT(errors_of(stressed), IsEmpty());
  EXPECT_THAT(errors_of(with("[[stage]]\nkind = \"gravity\"\n", "", stressed)),
              Contains(HasSubstr("the prop 'anchor' has a prestress, but there is no [[stage]] of kind "
                                 "\"gravity\"")));
}

TEST(Rules, PropsLeaveTheStep) {
  const auto warned = Contains(HasSubstr("sets the time step: the prop 'anchor' allows about"));
  EXPECT_THAT(remarks_of(with_prop()), Not(warned));
  EXPECT_THAT(remarks_of(prop_with("stiffness = 2e6", "stiffness = 2e11")), warned);
}

} // namespace
} // namespace tremolo::scene::testing
