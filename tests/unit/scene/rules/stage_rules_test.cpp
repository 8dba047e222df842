// The list of stages: their names, and what a case says of each kind that has no test of its own.

#include "rule_cases.hpp"

#include "scene/plan/stages/stages.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string rest = "[[stage]]\nkind = \"rest\"\nduration_s = 100.0\n";

std::string heavy(const std::string& more = "") {
  return with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n" + more + "[[stage]]");
}

std::string load(const std::string& keys = "x_m = [8.0, 12.0]\npressure_pa = 50e3\n") {
  return "[[stage]]\nkind = \"load\"\n" + keys;
}

/// A case with loads between gravity and shaking.
std::string loaded(const std::string& loads = load(), const std::string& text = std::string(flat_case)) {
  return with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n" + loads + "[[stage]]", text);
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

// The box is 20 m wide.
TEST(Rules, LoadsAreFarFromSides) {
  const auto far = HasSubstr("before a side whose free field does not have it");
  EXPECT_THAT(remarks_of(loaded()), Not(Contains(far)));
  EXPECT_THAT(remarks_of(loaded(load("x_m = [7.9, 11.9]\npressure_pa = 1e3\n"))),
              Contains(HasSubstr("'load' ends 7.9 m before a side")));
  EXPECT_THAT(remarks_of(loaded(load("x_m = [8.0, 12.1]\npressure_pa = 1e3\n"))), Contains(far));
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
  EXPECT_THAT(text, HasSubstr("1  gravity             gravity       weight of 9.81 m/s2"));
  EXPECT_THAT(text,
              HasSubstr("2  shaking             shaking       the motion enters; static tractions hold"));
  EXPECT_THAT(text, HasSubstr("100 s, from 2 s, or until no excess pore pressure ratio is above 0.01"));
}

TEST(Loads, ComeAfterGravity) {
  const Case scene =
      parse_case(loaded(load() + load("name = \"crane\"\nx_m = [4.0, 6.0]\nshear_pa = -5e3\n")));
  ASSERT_EQ(scene.loads.size(), 2u);
  EXPECT_EQ(scene.loads[0].x_max, 12.0);
  EXPECT_EQ(scene.loads[0].pressure, 50e3);
  EXPECT_EQ(scene.loads[1].shear, -5e3);
  EXPECT_THAT(stages_text(scene), HasSubstr("pressure of 50000 Pa on the surface from x = 8 to 12 m, which "
                                            "stays; grows in"));
  EXPECT_THAT(names_of(loaded()), ElementsAre("gravity", "load", "shaking"));
  EXPECT_THAT(errors_of(loaded(load() + load())),
              ElementsAre(HasSubstr("the stage in line 31 has the name 'load' already")));
  EXPECT_THAT(errors_of(with("[[stage]]", load() + "[[stage]]")),
              ElementsAre(HasSubstr("a load must come after a gravity stage")));
  EXPECT_THAT(
      errors_of(heavy() + load()),
      ElementsAre(HasSubstr("missing 'ramp_s': after a shaking the change grows in the soil's own time")));
  EXPECT_THAT(errors_of(with("[[stage]]", load() + "[[stage]]\nkind = \"gravity\"\n[[stage]]")),
              Contains(HasSubstr("the gravity stage must come before a load")));
}

TEST(Loads, HaveASizeAndTwoEnds) {
  EXPECT_THAT(errors_of(loaded(load("x_m = [8.0, 12.0]\n"))),
              ElementsAre(HasSubstr("missing 'pressure_pa' or 'shear_pa': how large the load is")));
  EXPECT_THAT(errors_of(loaded(load("pressure_pa = 1e3\n"))),
              ElementsAre(HasSubstr("missing 'x_m' or 'structure'")));
  EXPECT_THAT(errors_of(loaded(load("x_m = [12.0, 8.0]\npressure_pa = 1e3\n"))),
              ElementsAre(HasSubstr("'x_m' = [12, 8] goes from right to left")));
  EXPECT_THAT(errors_of(loaded(load("x_m = [8.0, 12.0]\npressure_pa = -1e3\n"))),
              ElementsAre(HasSubstr("-1000")));
}

TEST(Rules, LoadsActOnGround) {
  EXPECT_THAT(errors_of(loaded()), IsEmpty());
  const auto from_to = [](double from, double to) {
    return loaded(
        load("x_m = [" + std::to_string(from) + ", " + std::to_string(to) + "]\npressure_pa = 1e3\n"));
  };
  EXPECT_THAT(errors_of(from_to(18.0, 22.0)),
              ElementsAre(HasSubstr(
                  "[[stage]] the load 'load' lies beside the model, which goes from x = 0 to 20 m")));
  EXPECT_THAT(
      errors_of(from_to(0.0, 4.0)),
      ElementsAre(HasSubstr("reaches the left side of the model, whose free field does not have it")));
  EXPECT_THAT(errors_of(from_to(16.0, 20.0)), ElementsAre(HasSubstr("reaches the right side")));
  const std::string step = "[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [14.0, 0.0], [14.0, -3.0], [10.0, "
                           "-3.0], [10.0, 0.0], [0.0, 0.0]]";
  EXPECT_THAT(errors_of(with(std::string(polygon), step, loaded())),
              ElementsAre(HasSubstr("reaches over a wall of 3 m at x = 10 m")));
}

TEST(Rules, LoadsAreRamped) {
  EXPECT_THAT(remarks_of(loaded()), Not(Contains(HasSubstr("five periods"))));
  EXPECT_THAT(remarks_of(loaded(load("x_m = [8.0, 12.0]\npressure_pa = 1e3\nramp_s = 0.1\n"))),
              Contains(HasSubstr("the load 'load' comes within 0.1 s, less than five periods 4 H/c_s")));
}

} // namespace
} // namespace tremolo::scene::testing
