// Several shakings, each with a motion of its own and with rests between: what a case says of them, and the
// rules of it.

#include "rule_cases.hpp"

#include "scene/plan/output/intervals.hpp"
#include "scene/plan/stages/stages.hpp"
#include "scene/plan/wave/motion.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// The pulse of the first shaking comes at 1 s and has a peak of 0.1 m/s.
std::string pulse(const std::string& time = "1.5", const std::string& velocity = "0.05") {
  return "motion = { pulse = { shape = \"ricker\", frequency = 3.0, time = " + time +
         ", velocity = " + velocity + " } }\n";
}

std::string aftershock(const std::string& keys = pulse()) {
  return "[[stage]]\nkind = \"shaking\"\nname = \"aftershock\"\nduration_s = 3.0\n" + keys;
}

std::string rest(const std::string& keys = "") {
  return "[[stage]]\nkind = \"rest\"\nduration_s = 10.0\n" + keys;
}

TEST(Shakings, HaveMotionsOfTheirOwn) {
  const Case scene = parse_case(plus(rest() + aftershock() + rest("name = \"long rest\"\n")));
  ASSERT_EQ(scene.timed.size(), 4u);
  EXPECT_EQ(scene.timed[2].start, 12.0);
  EXPECT_EQ(scene.end_of_soil_time(), 25.0);
  ASSERT_EQ(scene.motion.shakings.size(), 2u);
  EXPECT_EQ(scene.motion.shakings[1].stage, 2u);
  EXPECT_EQ(scene.motion.shakings[1].start, 12.0);
  const Motion both = motion(scene.motion);
  EXPECT_EQ(both.velocity(1.0), 0.1);
  EXPECT_EQ(both.velocity(13.5), 0.05);
  EXPECT_EQ(both.velocity(5.0), 0.0);
  EXPECT_GT(both.end(), 13.5);
}

TEST(Shakings, BeginInSimulatedTime) {
  const std::string sand = with("[soil.sand]\nmodel = \"linear_elastic\"\ndensity = 1700.0\n",
                                "[water]\nlevel = 0.0\n[soil.sand]\nmodel = \"linear_elastic\"\nporosity = "
                                "0.4\npermeability = 1e-4\n",
                                with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]"));
  const Case scene = parse_case(
      sand + "[[stage]]\nkind = \"rest\"\nduration_s = 200.0\ntime_factor = 10.0\n" + aftershock());
  const double start = scene.motion.shakings[1].start;
  EXPECT_LT(start, 30.0);
  EXPECT_NEAR(scene.clock().time_of_soil(start), 202.0, 1e-9);
  EXPECT_NEAR(scene.end() - start, 3.0, 1e-9);
}

TEST(Shakings, OfTheSameTimeAddUp) {
  // The first pulse goes on when the second shaking has begun, at 2 s.
  const Motion both = motion(parse_case(plus(aftershock(pulse("-0.9", "0.2")))).motion);
  EXPECT_NEAR(both.velocity(1.05),
              Motion::ricker({3.0, 1.0, 0.1}).velocity(1.05) + Motion::ricker({3.0, 1.1, 0.2}).velocity(1.05),
              1e-15);
}

TEST(Shakings, SayWhatShakes) {
  EXPECT_THAT(
      errors_of(plus(aftershock(""))),
      ElementsAre(HasSubstr("missing [stage.motion], a 'file' or a 'pulse': what the ground is shaken with "
                            "again")));
  EXPECT_THAT(errors_of(plus(aftershock("motion = { scale = 0.5 }\n"))),
              ElementsAre(HasSubstr("[stage.motion] missing 'pulse' or 'file'")));
  EXPECT_THAT(errors_of(plus(aftershock("motion = { file = \"none.AT2\" }\n"))),
              ElementsAre(HasSubstr("[motion] missing 'kind', which a 'file' needs"), HasSubstr("none.AT2")));
  EXPECT_THAT(errors_of(plus(aftershock("motion = { angle_deg = 10.0 }\n"))),
              Contains(HasSubstr("[stage.motion] unknown key 'angle_deg'")));
  EXPECT_THAT(errors_of(with("duration_s = 2.0", "duration_s = 2.0\n" + pulse())),
              ElementsAre(HasSubstr("is that of a later shaking; the first one has [motion]")));
  EXPECT_THAT(errors_of(plus(rest(pulse()))),
              ElementsAre(HasSubstr("[stage.motion] does not apply to kind = \"rest\", only to shaking")));
}

TEST(Shakings, BeginAtATimeThatIsKnown) {
  EXPECT_THAT(errors_of(plus(rest("until_ratio = 0.01\n") + aftershock())),
              ElementsAre(HasSubstr("'until_ratio' ends the last stage only, and 'aftershock' comes after")));
  EXPECT_THAT(errors_of(plus(aftershock() + rest("until_ratio = 0.01\n"))), IsEmpty());
}

TEST(Shakings, EachBeginWithAFrame) {
  const Case scene = parse_case(plus("[output]\nevery_s = 0.75\n" + rest("every_s = 4.0\n") + aftershock()));
  std::vector<double> times{0.0};
  while (times.back() < 13.5)
    times.push_back(next_frame(scene, times.back(), times.back() + 0.01)); // written a little late
  EXPECT_THAT(times, ElementsAre(0.0, 0.75, 1.5, 2.0, 6.0, 10.0, 12.0, 12.75, 13.5));
  EXPECT_EQ(most_frames(scene, 0.01), 3 + 3 + 5);
}

TEST(Shakings, AreListed) {
  const std::string text = stages_text(parse_case(plus(rest() + aftershock())));
  EXPECT_THAT(text, HasSubstr("3  aftershock          shaking       a motion of its own enters"));
  EXPECT_THAT(text, HasSubstr("3 s, from 12 s"));
}

TEST(Rules, LaterWaveArrivesAfterItsStart) {
  EXPECT_THAT(remarks_of(plus(rest() + aftershock())), Not(Contains(HasSubstr("stage begins"))));
  EXPECT_THAT(remarks_of(plus(rest() + aftershock(pulse("0.1")))),
              Contains(AllOf(HasSubstr("[stage.motion] the wave reaches the model"),
                             HasSubstr("before its stage begins"), HasSubstr("in the stage before"))));
}

TEST(Rules, LastMotionEndsBeforeRun) {
  EXPECT_THAT(remarks_of(plus(rest() + aftershock())), Not(Contains(HasSubstr("after the run's end"))));
  EXPECT_THAT(
      remarks_of(plus(rest() + aftershock(pulse("2.95")))),
      Contains(AllOf(HasSubstr("[stage.motion]"), HasSubstr("reaches the model after the run's end"))));
}

} // namespace
} // namespace tremolo::scene::testing
