// The rest after shaking: what a case says of it, and the rules of it, each with a case that keeps it and one
// that breaks it, and the message.

#include "rule_cases.hpp"

#include "scene/plan/output/intervals.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/rest/fast_rest.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// 10 m of saturated sand, shaken for 2 s by a pulse at 1 s, 99 % of which has come at 1.2 s.
std::string sand(const std::string& more = "", const std::string& law = "contraction_rate = 0.4\n") {
  return with("[soil.sand]\nmodel = \"linear_elastic\"\ndensity = 1700.0\nyoung = 40e6\npoisson = 0.28\n",
              "[water]\nlevel = 0.0\n[soil.sand]\nmodel = \"pm4sand\"\nrelative_density = "
              "0.55\nshear_modulus_coefficient = 677.0\nporosity = 0.4\npermeability = 1e-4\n" +
                  law,
              with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]")) +
         more;
}

std::string rest(const std::string& keys = "") {
  return "[[stage]]\nkind = \"rest\"\nduration_s = 100.0\n" + keys;
}

/// A case with one soil more, which holds its water.
std::string with_clay(const std::string& text) {
  return with("[soil.sand]",
              "[soil.clay]\nmodel = \"linear_elastic\"\nporosity = 0.4\ndrainage = \"undrained\"\nyoung = "
              "40e6\npoisson = 0.28\n[soil.sand]",
              text);
}

TEST(Rest, ComesAfterAShaking) {
  EXPECT_THAT(errors_of(plus(rest())), IsEmpty());
  EXPECT_THAT(errors_of(plus(rest() + rest("name = \"long rest\"\n"))), IsEmpty());
  EXPECT_THAT(errors_of(with("[[stage]]", rest() + "[[stage]]")),
              ElementsAre("case.toml:29:8: [[stage]] a rest must come after a shaking stage"));
  EXPECT_THAT(errors_of(plus(rest() + "[[stage]]\nkind = \"gravity\"\n")),
              ElementsAre(HasSubstr("the gravity stage must come before the shaking stage")));
  EXPECT_THAT(errors_of(plus("[[stage]]\nkind = \"rest\"\n")),
              ElementsAre(HasSubstr("missing 'duration_s'")));
  EXPECT_THAT(errors_of(with("duration_s = 2.0", "duration_s = 2.0\ntime_factor = 2.0")),
              ElementsAre(HasSubstr("'time_factor' does not apply to kind = \"shaking\", only to rest")));
}

TEST(Rest, LengthensTheRunByItsTime) {
  const Case plain = parse_case(plus(rest("every_s = 2.0\nhistory_every_s = 0.5\n")));
  EXPECT_EQ(plain.end(), 102.0);
  EXPECT_EQ(plain.end_of_soil_time(), 102.0);
  EXPECT_EQ(plain.timed.back().rest->every, 2.0);
  EXPECT_EQ(plain.timed.back().rest->history_every, 0.5);
  const Plan planned = plan(plain);
  EXPECT_NEAR(static_cast<double>(planned.steps) * planned.dt, 102.0, planned.dt);
  EXPECT_EQ(planned.frames, 21 + 51);                          // every 0.1 s, then every 2 s
  EXPECT_EQ(plan(parse_case(plus(rest()))).frames, 21 + 1001); // as [output] says
  // 2 (1 + 1.5 + ...) of 8 intervals are 98.5 s
  EXPECT_EQ(plan(parse_case(plus(rest("every_s = 2.0\ngrowth = 1.5\n")))).frames, 21 + 9);
  EXPECT_EQ(parse_case(std::string(flat_case)).fastest_rest(), nullptr);
}

TEST(Rest, BeginsWithAFrame) {
  const Case scene = parse_case(plus("[output]\nevery_s = 0.75\n" + rest("every_s = 1.0\ngrowth = 1.5\n")));
  std::vector<double> times{0.0};
  while (times.back() < 7.0)
    times.push_back(next_frame(scene, times.back(), times.back() + 0.01)); // written a little late
  EXPECT_THAT(times, ElementsAre(0.0, 0.75, 1.5, 2.0, 3.0, 4.5, 6.75, 10.125));
  EXPECT_EQ(next_row(scene, 1.995, 1.999), 2.0);
}

TEST(Rest, HasFramesAtGivenTimes) {
  const Case scene = parse_case(plus("[output]\nevery_s = 1.0\n" + rest("times_s = [0.5, 10, 60.0]\n")));
  std::vector<double> times{0.0};
  while (times.back() < 62.0)
    times.push_back(next_frame(scene, times.back(), times.back() + 0.01)); // written a little late
  EXPECT_THAT(times, ElementsAre(0.0, 1.0, 2.0, 2.5, 12.0, 62.0));
  EXPECT_EQ(next_frame(scene, 62.0, 62.01), std::numeric_limits<double>::infinity()); // but for the last one
  EXPECT_EQ(plan(scene).frames, 3 + 4);
  EXPECT_THAT(errors_of(plus(rest("times_s = [10.0, 5.0]\n"))),
              ElementsAre(HasSubstr("'times_s' must rise, from more than 0 s")));
  EXPECT_THAT(errors_of(plus(rest("times_s = [10.0, 500.0]\n"))),
              ElementsAre(HasSubstr("'times_s' goes to 500 s, and the rest ends after 100 s")));
  EXPECT_THAT(errors_of(plus(rest("times_s = [10.0]\nevery_s = 1.0\n"))),
              ElementsAre(HasSubstr("'every_s' and 'times_s' both say when frames are written")));
}

TEST(Rest, WithATimeFactorIsShorterToSimulate) {
  const Case fast = parse_case(sand(rest("time_factor = 10.0\n")));
  EXPECT_EQ(fast.end_of_soil_time(), 102.0);
  // The factor rises by a power in 2 s, within which 9 s/ln(10)*2 of the soil's time pass.
  const double in_rise = 2.0 * 9.0 / std::log(10.0);
  EXPECT_NEAR(fast.end(), 2.0 + 2.0 + (100.0 - in_rise) / 10.0, 1e-9);
}

TEST(Rest, HasAsManyFramesASecondOfSimulationAsTheShaking) {
  const std::string output = "[output]\nevery_s = 0.5\nhistory_every_s = 0.02\n";
  const Case fast = parse_case(sand(output + rest("time_factor = 10.0\n")));
  EXPECT_NEAR(next_frame(fast, 2.0, 2.0), 2.0 + 5.0, 1e-12);
  EXPECT_NEAR(next_row(fast, 2.0, 2.0), 2.0 + 0.2, 1e-12);
  const Case given =
      parse_case(sand(output + rest("time_factor = 10.0\nevery_s = 1.0\nhistory_every_s = 0.1\n")));
  EXPECT_NEAR(next_frame(given, 2.0, 2.0), 2.0 + 1.0, 1e-12);
  EXPECT_NEAR(next_row(given, 2.0, 2.0), 2.0 + 0.1, 1e-12);
}

TEST(Rest, IsAnEffectOfThePlan) {
  const auto why = [](const std::string& text) {
    const Plan planned = plan(parse_case(text));
    const auto effect = std::ranges::find(planned.effects, "reconsolidation", &Effect::name);
    return effect->on ? effect->why : "off";
  };
  EXPECT_EQ(why(sand(rest())), "[[stage]] rest from 2 to 102 s: soil 'sand'");
  EXPECT_EQ(why(plus(rest())),
            "[[stage]] rest from 2 to 102 s: no soil of the domain changes its law in the rest");
  EXPECT_EQ(why(sand()), "off");
}

TEST(Rules, ShakenSandRests) {
  EXPECT_THAT(remarks_of(sand()), Not(Contains(HasSubstr("Arias")))); // 0.8 s of draining cost little
  const std::string longer = with("duration_s = 2.0", "duration_s = 5.0", sand());
  EXPECT_THAT(remarks_of(longer),
              Contains(AllOf(HasSubstr("99 % of the motion's Arias intensity has arrived at 1.2 s"),
                             HasSubstr("soil 'sand' drains as if it had not been shaken"),
                             HasSubstr("End the shaking at about 2 s"))));
  EXPECT_THAT(remarks_of(longer + rest()),
              Contains(HasSubstr("Let the rest begin at about 2 s (docs/stages.md)")));
  EXPECT_THAT(remarks_of(sand(rest())), Not(Contains(HasSubstr("Arias"))));
  EXPECT_THAT(remarks_of(with("duration_s = 2.0", "duration_s = 1.0", sand(rest()))),
              Contains(AllOf(HasSubstr("the rest begins at 1 s, before 95 %"), HasSubstr("still shaken"))));
  // Other soil, and sand whose water cannot leave, has nothing to say.
  EXPECT_THAT(remarks_of(with("duration_s = 2.0", "duration_s = 5.0")), Not(Contains(HasSubstr("Arias"))));
  EXPECT_THAT(remarks_of(with("permeability = 1e-4", "drainage = \"undrained\"", longer)),
              Not(Contains(HasSubstr("Arias"))));
}

TEST(Rules, RestingSandIsShakenFirst) {
  const std::string shaken = "contraction_rate = 0.4\npost_shake = true\n";
  EXPECT_THAT(errors_of(sand("", shaken)), IsEmpty());
  EXPECT_THAT(errors_of(sand(rest(), shaken)),
              ElementsAre(AllOf(HasSubstr("'post_shake' = true"), HasSubstr("remove the key"))));
}

TEST(Rules, TimeFactorIsAllowed) {
  const auto errors_with = [](const std::string& factor, const std::string& text) {
    return errors_of(text + rest("time_factor = " + factor + "\n"));
  };
  EXPECT_THAT(errors_with("20.0", sand()), IsEmpty());
  // Pi = 0.1 with M = 0.24 GPa, 1990 kg/m3 and 10 m is F = 142; F k = 0.01 m/s is F = 100.
  EXPECT_THAT(errors_with("90.0", sand()), IsEmpty());
  EXPECT_THAT(errors_with("110.0", sand()),
              ElementsAre(AllOf(HasSubstr("makes soil 'sand' let water flow by 0.011 m/s"),
                                HasSubstr("allowed: at most 100"))));
  EXPECT_THAT(errors_with("150.0", sand()),
              ElementsAre(HasSubstr("inertia counts"), HasSubstr("at most 100")));
  EXPECT_THAT(errors_with("2.0", with("permeability = 1e-4", "permeability = 0.02", sand())),
              Contains(HasSubstr("allowed: none, that is 1")));
  EXPECT_THAT(errors_with("20.0", std::string(flat_case)), ElementsAre(HasSubstr("has nothing to speed up")));
  EXPECT_THAT(errors_with("20.0", sand("[damping]\nmodel = \"rayleigh\"\nfrequencies = [1.0, 5.0]\n")),
              ElementsAre(HasSubstr("does not go with [damping] model = \"rayleigh\"")));
}

/// What drains 2 m of the wet 10 m is five times as short a way.
TEST(Rest, KnowsTheHeightThatDrains) {
  const std::string clay = with_clay(sand(rest("time_factor = 10.0\n")));
  const std::string lens =
      with("polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]",
           "polygon = [[0.0, -6.0], [20.0, -6.0], [20.0, -4.0], [0.0, -4.0]]\n"
           "[[region]]\nsoil = \"clay\"\npolygon = [[0.0, -10.0], [20.0, -10.0], [20.0, -6.0], "
           "[0.0, -6.0]]\n[[region]]\nsoil = \"clay\"\npolygon = [[0.0, -4.0], [20.0, -4.0], "
           "[20.0, 0.0], [0.0, 0.0]]",
           clay);
  const auto all = fast_rest(parse_case(clay)), some = fast_rest(parse_case(lens));
  EXPECT_NEAR(some->slow_wave / all->slow_wave, 5.0, 1e-9);
  EXPECT_NEAR(some->ringing / all->ringing, 1.0, 1e-9);
}

/// Sand that only the free field of a side has drains as well.
TEST(Rest, KnowsTheLayersOfASide) {
  const std::string beside =
      with("left = { model = \"wave\" }\nright = { model = \"wave\" }\nbase = { model = \"wave\", form = "
           "\"total\" }\n",
           "right = { model = \"wave\" }\nbase = { model = \"wave\" }\n[boundary.left]\nmodel = "
           "\"fe\"\n[[boundary.left.profile]]\nthickness = 10.0\nsoil = \"sand\"\n",
           with("[[region]]\nsoil = \"sand\"", "[[region]]\nsoil = \"clay\"",
                with_clay(sand(rest("time_factor = 10.0\n")))));
  EXPECT_EQ(fast_rest(parse_case(beside))->slow_wave,
            fast_rest(parse_case(sand(rest("time_factor = 10.0\n"))))->slow_wave);
}

/// M = 0.24 GPa, rho = 1990 kg/m3, H = 10 m, k = 1e-4 m/s: Pi = F 1e-4 sqrt(M rho)/(9.81e3 10).
TEST(Rules, TimeFactorErrsLittle) {
  const auto remarks_with = [](const std::string& factor) {
    return remarks_of(sand(rest("time_factor = " + factor + "\n")));
  };
  const Case scene = parse_case(sand(rest("time_factor = 50.0\n")));
  const double m = materials::elasticity(scene.soils[0].law).p_modulus();
  EXPECT_NEAR(fast_rest(scene)->slow_wave, 50e-4 * std::sqrt(m * 1990.0) / 98100.0, 1e-9);
  EXPECT_NEAR(fast_rest(scene)->ringing, 0.024, 0.002);
  EXPECT_THAT(remarks_with("10.0"), Not(Contains(HasSubstr("time_factor"))));
  EXPECT_THAT(remarks_with("50.0"),
              Contains(HasSubstr("makes inertia count: the settlement that the rest adds will "
                                 "be off by about")));
  const auto early = with("duration_s = 2.0", "duration_s = 1.0", sand(rest("time_factor = 10.0\n")));
  EXPECT_THAT(remarks_of(early),
              Contains(HasSubstr("what is left of the motion acts on ground in which water")));
}

} // namespace
} // namespace tremolo::scene::testing
