// Earthworks after a shaking: these tests hold how a case states them, and their rules, each with a case that
// keeps it and one that breaks it.

#include "../structure_case.hpp"
#include "rule_cases.hpp"

#include "scene/plan/stages/stages.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string region(const std::string& name, const std::string& polygon) {
  return "[[region]]\nsoil = \"sand\"\nname = \"" + name + "\"\npolygon = " + polygon + "\n";
}

std::string stage(const std::string& kind, const std::string& keys) {
  return "[[stage]]\nkind = \"" + kind + "\"\n" + keys + "\n";
}

const std::string fill = region("fill", "[[11.0, 0.0], [15.0, 0.0], [14.0, 2.0], [12.0, 2.0]]");
const std::string repair = stage("construction", "name = \"repair\"\nplace = [\"fill\"]\nramp_s = 2.0");
const std::string trial =
    stage("load", "name = \"crane\"\nx_m = [4.0, 6.0]\npressure_pa = 1e3\nramp_s = 2.0");

/// The flat case with weight and a fill beside it, and what follows its shaking.
std::string shaken(const std::string& then, const std::string& regions = fill,
                   const std::string& text = heavy()) {
  return with("box = [0.0, -10.0, 20.0, 0.0]", "box = [0.0, -10.0, 20.0, 4.0]", text) + then + regions;
}

TEST(Earthworks, ComeAfterAShakingInTheSoilsOwnTime) {
  const Case scene = parse_case(shaken(repair + trial));
  ASSERT_EQ(scene.earthworks.size(), 1u);
  EXPECT_TRUE(scene.constructions.empty());
  EXPECT_EQ(scene.earthworks[0].placed.size(), 1u);
  EXPECT_EQ(scene.earthworks[0].start, 2.0);
  EXPECT_EQ(scene.regions.size(), 1u); // the fill does not stand while the ground is shaken
  EXPECT_EQ(scene.earthworks[0].after.regions.size(), 2u);
  ASSERT_EQ(scene.loads.size(), 1u);
  EXPECT_EQ(scene.loads[0].start, 4.0);
  EXPECT_TRUE(static_stages(scene).empty());
  EXPECT_EQ(scene.end_of_soil_time(), 6.0);
  const std::string text = stages_text(scene);
  EXPECT_THAT(text,
              HasSubstr("repair              construction  places 'fill'; grows in 2 s of the soil's own "
                        "time, from 2 s"));
  EXPECT_THAT(text,
              HasSubstr("from x = 4 to 6 m, which stays; grows in 2 s of the soil's own time, from 4 s"));
}

TEST(Earthworks, SayHowLongTheyLastAndNothingOfRelaxation) {
  EXPECT_THAT(
      errors_of(shaken(stage("construction", "place = [\"fill\"]"))),
      ElementsAre(HasSubstr("missing 'ramp_s': after a shaking the change grows in the soil's own time")));
  for (const char* const key : {"residual = 1e-6", "max_time_s = 10.0", "drainage = \"undrained\""})
    EXPECT_THAT(errors_of(shaken(repair + key + "\n")),
                ElementsAre(HasSubstr("is of stages before the shaking, which relax to rest")));
  EXPECT_THAT(
      errors_of(shaken(stage("water", "level = -1.0"))),
      Contains(HasSubstr("a water stage must come before the shaking stage: after it water flows in its "
                         "own time")));
}

TEST(Earthworks, PlaceAndRemoveSoilThatIsThere) {
  EXPECT_THAT(errors_of(shaken(stage("construction", "name = \"a\"\nplace = [\"fil\"]\nramp_s = 2.0"))),
              Contains(HasSubstr(
                  "no [[region]], [[structure]] or [[prop]] has the name 'fil', did you mean 'fill'?")));
  EXPECT_THAT(errors_of(shaken(stage("construction", "name = \"a\"\nremove = [\"fill\"]\nramp_s = 2.0"))),
              IsEmpty());
  EXPECT_THAT(
      errors_of(shaken(repair + stage("construction", "name = \"a\"\nplace = [\"fill\"]\nramp_s = 2.0"))),
      ElementsAre(HasSubstr("'fill' stands already, since the stage 'repair'")));
  const std::string block =
      "[[structure]]\nname = \"block\"\nrigid = true\ndensity = 2400.0\nfriction = 0.5\n"
      "polygon = [[6.0, 0.0], [10.0, 0.0], [10.0, 2.0], [6.0, 2.0]]\n";
  EXPECT_THAT(
      errors_of(shaken(stage("construction", "place = [\"block\"]\nramp_s = 2.0"), block)),
      Contains(HasSubstr("'block' is a structure: after a shaking soil alone is placed and removed")));
}

TEST(Rules, LaterModelsAreSound) {
  EXPECT_THAT(errors_of(shaken(repair)), IsEmpty());
  EXPECT_THAT(
      errors_of(shaken(repair, region("fill", "[[11.0, -1.0], [15.0, -1.0], [14.0, 2.0], [12.0, 2.0]]"))),
      Contains(HasSubstr("regions may touch but not overlap")));
}

TEST(Rules, EarthworksAreDry) {
  const std::string wet = with("[soil.sand]\n",
                               "[water]\nlevel = 0.0\n[soil.sand]\nporosity = 0.4\n"
                               "grain_density = 2650.0\npermeability = 1e-4\n",
                               heavy());
  const auto messages = [&](const std::string& level) {
    return errors_of(shaken(repair, fill, with("level = 0.0\n[soil", "level = " + level + "\n[soil", wet)));
  };
  EXPECT_THAT(messages("-1.0"), Not(Contains(HasSubstr("below the water"))));
  EXPECT_THAT(messages("1.0"),
              Contains(HasSubstr("'fill' reaches down to y = 0 m, below the water at y = 1 m")));
}

TEST(Rules, EarthworksSpareSides) {
  EXPECT_THAT(errors_of(shaken(repair)), IsEmpty());
  EXPECT_THAT(errors_of(shaken(repair, region("fill", "[[0.5, 0.0], [4.0, 0.0], [4.0, 2.0], [0.5, 2.0]]"))),
              ElementsAre(HasSubstr("'fill' comes nearer to a side than two cells")));
}

TEST(Rules, EarthworksSpareWhatRidesOnSoil) {
  const std::string dig = stage("construction", "name = \"dig\"\nremove = [\"fill\"]\nramp_s = 2.0");
  const auto with_output = [&](const std::string& then, const std::string& more) {
    return errors_of(shaken(then) + more);
  };
  EXPECT_THAT(with_output(dig, "[[monitor]]\nname = \"m\"\npoint = [5.0, -1.0]\n"), IsEmpty());
  EXPECT_THAT(with_output(dig, "[[monitor]]\nname = \"m\"\npoint = [13.0, 1.0]\n"),
              ElementsAre(HasSubstr("'fill' lies where the monitor 'm' is")));
  EXPECT_THAT(
      with_output(dig, "[[line]]\nname = \"l\"\nfrom = [13.0, 1.5]\nto = [13.0, -3.0]\nspacing = 1.0\n"),
      ElementsAre(HasSubstr("the line 'l' is")));
  const std::string mass =
      "[[sliding_mass]]\nname = \"s\"\npolygon = [[12.0, -1.0], [14.0, -1.0], [14.0, 0.5], [12.0, 0.5]]\n";
  EXPECT_THAT(with_output(dig, mass), Contains(HasSubstr("the sliding mass 's' is")));
  EXPECT_THAT(with_output(repair, stage("load", "x_m = [11.0, 13.0]\npressure_pa = 1e3\nramp_s = 2.0")),
              ElementsAre(HasSubstr("'fill' lies where the load 'load' is")));
}

} // namespace
} // namespace tremolo::scene::testing
