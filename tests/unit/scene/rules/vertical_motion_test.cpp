// [motion.vertical], the P wave beside the SV wave: what a case says of it, and the rules of two plane waves.

#include "rule_cases.hpp"

#include "scene/plan/plan.hpp"
#include "scene/plan/resolved.hpp"
#include "scene/plan/wave/slowness.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* p_pulse =
    "pulse = { shape = \"ricker\", frequency = 5.0, time = 1.0, velocity = 0.05 }\n";

std::string vertical(const std::string& angle = "0.0", const std::string& keys = "") {
  return std::string("[motion.vertical]\n") + p_pulse + "angle_deg = " + angle + "\n" + keys;
}

/// The flat case with the wave at an angle and [motion.vertical].
std::string at(const std::string& angle, const std::string& beside,
               std::string text = std::string(flat_case)) {
  return with("angle_deg = 0.0", "angle_deg = " + angle, text) + beside;
}

TEST(VerticalMotion, IsAPWaveBesideTheSvWave) {
  const Case scene = parse_case(plus(vertical()));
  ASSERT_TRUE(scene.vertical);
  EXPECT_EQ(scene.plane_waves().size(), 2u);
  EXPECT_EQ(scene.vertical->wave, Wave::p);
  EXPECT_EQ(scene.vertical->reference.y, scene.motion.reference.y);
  EXPECT_EQ(std::get<RickerPulse>(scene.vertical->shakings.front().source).frequency, 5.0);
  EXPECT_EQ(parse_case(plus(vertical("0.0", "reference = [1.0, -12.0]\n"))).vertical->reference.x, 1.0);
  EXPECT_FALSE(parse_case(std::string(flat_case)).vertical);
}

TEST(VerticalMotion, IsListed) {
  EXPECT_THAT(
      explain(parse_case(plus(vertical())), plan(parse_case(plus(vertical())))),
      AllOf(HasSubstr("incident motion of the SV wave at 0 degrees"),
            HasSubstr("and      Ricker pulse of 5 Hz, 0.05 m/s at 1 s, incident motion of the P wave")));
}

TEST(VerticalMotion, IsServedAsAFieldOfItsOwn) {
  const Case scene = parse_case(at("10.0", vertical("20.0")));
  EXPECT_THAT(resolved_json(scene, plan(scene)), HasSubstr("\"total+vertical\""));
  EXPECT_LT(slowness_x(scene, scene.motion), slowness_x(scene, *scene.vertical));
  const Case columns = parse_case(with_columns() + vertical());
  EXPECT_THAT(resolved_json(columns, plan(columns)), Not(HasSubstr("total+vertical")));
}

TEST(VerticalMotion, NeedsAnAngleAndAnSvWave) {
  EXPECT_THAT(errors_of(plus(std::string("[motion.vertical]\n") + p_pulse)),
              ElementsAre(HasSubstr("missing 'angle_deg'")));
  EXPECT_THAT(errors_of(with("wave = \"SV\"", "wave = \"P\"") + vertical()),
              ElementsAre(HasSubstr("comes up beside an SV wave, but [motion] has wave = \"P\"")));
  EXPECT_THAT(errors_of(plus("[motion.vertical]\nangle_deg = 0.0\n")),
              ElementsAre(HasSubstr("missing 'pulse' or 'file'")));
  EXPECT_THAT(errors_of(plus(vertical("0.0", "wave = \"P\"\n"))),
              ElementsAre(HasSubstr("unknown key 'wave'")));
}

TEST(VerticalMotion, HasTheKindOfTheMotion) {
  const Case scene = parse_case(with("[motion]\n", "[motion]\nkind = \"outcrop\"\n") + vertical());
  EXPECT_EQ(scene.vertical->kind, motion::MotionKind::outcrop);
}

TEST(VerticalMotion, ShakesAgainInALaterStage) {
  const std::string motion =
      "motion = { pulse = { shape = \"ricker\", frequency = 3.0, time = 1.5, velocity = 0.05 }, vertical = { "
      "pulse = { shape = \"ricker\", frequency = 6.0, time = 1.5, velocity = 0.02 } } }\n";
  const std::string again =
      "[[stage]]\nkind = \"shaking\"\nname = \"aftershock\"\nduration_s = 3.0\n" + motion;
  const Case scene = parse_case(plus(vertical() + again));
  ASSERT_EQ(scene.vertical->shakings.size(), 2u);
  EXPECT_EQ(scene.vertical->shakings[1].start, 2.0);
  EXPECT_EQ(std::get<RickerPulse>(scene.vertical->shakings[1].source).frequency, 6.0);
  EXPECT_THAT(errors_of(plus(again)), ElementsAre(HasSubstr("needs [motion.vertical]")));
}

TEST(Rules, ColumnsTakeWavesOfOneSpeedAlongX) {
  const Case scene = parse_case(std::string(flat_case));
  const double ratio = scene.halfspace.p_wave_speed() / scene.halfspace.s_wave_speed();
  const double beside =
      std::asin(ratio * std::sin(10.0 * std::numbers::pi / 180.0)) * 180.0 / std::numbers::pi;
  EXPECT_THAT(errors_of(at("10.0", vertical(std::to_string(beside)), with_columns())), IsEmpty());
  EXPECT_THAT(errors_of(at("10.0", vertical("10.0"), with_columns())),
              Contains(AllOf(HasSubstr("takes waves of one speed along x"),
                             HasSubstr(fmt::format("has angle_deg = {:.4g}", beside)),
                             HasSubstr("use model = \"wave\""))));
  EXPECT_THAT(errors_of(at("10.0", vertical("10.0"))), IsEmpty());
}

TEST(Rules, TheEquivalentLinearIterationKnowsTheShearOfTheSvWaveAlone) {
  std::string text(flat_case);
  for (const auto* side : {"left = ", "right = ", "base = "})
    text = with(std::string(side) + "{ model = \"wave\"", std::string(side) + "{ model = \"eql\"", text);
  EXPECT_THAT(errors_of(at("10.0", vertical("0.0"), text)), IsEmpty());
  EXPECT_THAT(errors_of(at("10.0", vertical("5.0"), text)),
              Contains(HasSubstr("the P wave of [motion.vertical] shears the ground too at angle_deg = 5")));
}

TEST(Rules, PeriodicSidesTakeNoWaveAtAnAngle) {
  const auto periodic =
      with("left = { model = \"wave\" }\nright = { model = \"wave\" }\n", "sides = \"periodic\"\n");
  EXPECT_THAT(errors_of(periodic + vertical()), IsEmpty());
  EXPECT_THAT(errors_of(periodic + vertical("5.0")),
              Contains(HasSubstr("a wave at [motion.vertical] angle_deg = 5 reaches")));
}

TEST(Rules, OutcropMovesAsRecorded) {
  const auto outcrop = with("[motion]\n", "[motion]\nkind = \"outcrop\"\n");
  EXPECT_THAT(remarks_of(outcrop + vertical()), Not(Contains(HasSubstr("moves the outcrop"))));
  EXPECT_THAT(remarks_of(at("10.0", vertical("20.0"), outcrop)),
              Contains(HasSubstr("moves the outcrop as its own record says")));
  EXPECT_THAT(remarks_of(at("10.0", vertical("20.0"))), Not(Contains(HasSubstr("moves the outcrop"))));
}

TEST(Rules, BothWavesArriveAfterTheStart) {
  EXPECT_THAT(remarks_of(plus(vertical())), Not(Contains(HasSubstr("the wave reaches the model"))));
  EXPECT_THAT(
      remarks_of(with("time = 1.0, velocity = 0.05", "time = 0.0, velocity = 0.05", plus(vertical()))),
      Contains(AllOf(HasSubstr("[motion.vertical]"), HasSubstr("the wave reaches the model"))));
  EXPECT_THAT(
      remarks_of(with("time = 1.0, velocity = 0.05", "time = 2.0, velocity = 0.05", plus(vertical()))),
      Contains(AllOf(HasSubstr("[motion.vertical]"), HasSubstr("after the run's end"))));
}

} // namespace
} // namespace tremolo::scene::testing
