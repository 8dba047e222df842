// Constructions: what can be placed and removed, and what stands when.

#include "rule_cases.hpp"

#include "scene/plan/stages/stages.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string region(const std::string& name, const std::string& polygon) {
  return "[[region]]\nsoil = \"sand\"\nname = \"" + name + "\"\npolygon = " + polygon + "\n";
}

/// A pit's soil and a fill on the ground beside it, and what is built; the ground below and around is that of
/// the flat case.
std::string built(const std::string& stages, const std::string& more = "") {
  std::string text(flat_case);
  text = with("polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]",
              "polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [10.0, 0.0], [10.0, -2.0], [6.0, -2.0], "
              "[6.0, 0.0], [0.0, 0.0]]",
              text);
  text = with("box = [0.0, -10.0, 20.0, 0.0]", "box = [0.0, -10.0, 20.0, 4.0]", text);
  text = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n" + stages + "[[stage]]", text);
  return text + region("pit", "[[6.0, -2.0], [10.0, -2.0], [10.0, 0.0], [6.0, 0.0]]") +
         region("fill", "[[11.0, 0.0], [15.0, 0.0], [14.0, 2.0], [12.0, 2.0]]") + more;
}

std::string stage(const std::string& name, const std::string& keys) {
  return "[[stage]]\nkind = \"construction\"\nname = \"" + name + "\"\n" + keys + "\n";
}

const std::string dig = stage("dig", "remove = [\"pit\"]");
const std::string bank = stage("bank", "place = [\"fill\"]");
const std::string block = "[[structure]]\nname = \"block\"\nrigid = true\ndensity = 2400.0\nfriction = 0.5\n"
                          "polygon = [[6.0, -2.0], [10.0, -2.0], [10.0, 1.0], [6.0, 1.0]]\n";

TEST(Constructions, KeepWhatStandsUntilThem) {
  const Case scene = parse_case(built(dig + bank));
  ASSERT_EQ(scene.constructions.size(), 2u);
  const auto names = [](const std::vector<Region>& regions) {
    std::vector<std::string> found;
    for (const Region& one : regions)
      found.push_back(one.name);
    return found;
  };
  EXPECT_THAT(names(scene.constructions[0].before.regions), ElementsAre("", "pit"));
  EXPECT_THAT(names(scene.constructions[1].before.regions), ElementsAre(""));
  EXPECT_THAT(names(scene.regions), ElementsAre("", "fill"));
}

TEST(Constructions, AreListedWithWhatTheyChange) {
  const std::string text = stages_text(
      parse_case(built(stage("swap", "remove = [\"pit\"]\nplace = [\"fill\"]\ndrainage = \"undrained\""))));
  EXPECT_THAT(text, HasSubstr("swap                construction  removes 'pit', places 'fill'; grows in"));
  EXPECT_THAT(text, HasSubstr("s of relaxation, undrained, then until at rest"));
}

TEST(Constructions, BringStructuresAndTakeTheirMonitorsAlong) {
  const std::string other = "[[structure]]\nname = \"shed\"\nrigid = true\ndensity = 500.0\nfriction = 0.5\n"
                            "polygon = [[2.0, 0.0], [5.0, 0.0], [5.0, 2.0], [2.0, 2.0]]\n";
  const std::string monitor = "[[monitor]]\nname = \"top\"\npoint = [8.0, 0.5]\nstructure = \"block\"\n";
  const Case scene =
      parse_case(built(stage("dig", "remove = [\"pit\", \"shed\"]") + stage("build", "place = [\"block\"]"),
                       other + block + monitor));
  ASSERT_EQ(scene.structures.size(), 1u);
  EXPECT_EQ(scene.structures.front().name, "block");
  EXPECT_EQ(*scene.monitors.front().structure, 0u);
  EXPECT_THAT(errors_of(built(stage("clear", "remove = [\"block\"]"), block + monitor)),
              Contains(HasSubstr("the structure 'block' is removed before the shaking")));
}

TEST(Constructions, NameWhatIsThere) {
  EXPECT_THAT(errors_of(built(stage("dig", "remove = [\"pitt\"]"))),
              ElementsAre(HasSubstr(
                  "no [[region]], [[structure]] or [[prop]] has the name 'pitt', did you mean 'pit'?")));
  EXPECT_THAT(errors_of(built(dig + stage("again", "remove = [\"pit\"]"))),
              ElementsAre(HasSubstr("'pit' cannot go: it is not there since the stage 'dig'")));
  EXPECT_THAT(errors_of(built(bank + stage("more", "place = [\"fill\"]"))),
              ElementsAre(HasSubstr("'fill' stands already, since the stage 'bank'")));
  EXPECT_THAT(errors_of(built(bank + stage("trim", "remove = [\"fill\"]"))), IsEmpty());
  EXPECT_THAT(errors_of(built(stage("trim", "remove = [\"fill\"]") + bank)), IsEmpty()); // there at the start
  EXPECT_THAT(errors_of(built("[[stage]]\nkind = \"construction\"\n")),
              ElementsAre(HasSubstr("missing 'place' or 'remove': what is built")));
  EXPECT_THAT(
      errors_of(built(dig, "[[structure]]\nname = \"pit\"\nrigid = true\ndensity = 500.0\nfriction = 0.5\n"
                           "polygon = [[2.0, 0.0], [5.0, 0.0], [5.0, 2.0], [2.0, 2.0]]\n")),
      Contains(HasSubstr("has the name 'pit' too")));
}

TEST(Constructions, ComeAfterGravity) {
  EXPECT_THAT(errors_of(with("[[stage]]\nkind = \"gravity\"\n", "", built(bank))),
              ElementsAre(HasSubstr("a construction must come after a gravity stage")));
}

// Regions may overlap if they are never there at the same time.
TEST(Rules, EarlierModelsAreSound) {
  const std::string backfill = region("backfill", "[[6.0, -2.0], [10.0, -2.0], [10.0, -0.5], [6.0, -0.5]]");
  EXPECT_THAT(errors_of(built(dig + stage("refill", "place = [\"backfill\"]"), backfill)), IsEmpty());
  EXPECT_THAT(errors_of(built(stage("refill", "place = [\"backfill\"]") + dig, backfill)),
              ElementsAre(HasSubstr("'polygon' overlaps the one in line")));
  EXPECT_THAT(errors_of(built(bank + stage("trim", "remove = [\"fill\"]"),
                              region("up", "[[2.0, 3.0], [5.0, 3.0], [5.0, 5.0], [2.0, 5.0]]"))),
              Contains(HasSubstr("lies outside the mesh")));
  // The block hangs in the air until the fill comes.
  const std::string high = "[[structure]]\nname = \"block\"\nrigid = true\ndensity = 500.0\nfriction = 0.5\n"
                           "polygon = [[12.0, 2.0], [14.0, 2.0], [14.0, 4.0], [12.0, 4.0]]\n";
  EXPECT_THAT(errors_of(built(bank, high)), Contains(HasSubstr("touches no soil")));
  EXPECT_THAT(errors_of(built(stage("bank", "place = [\"fill\", \"block\"]"), high)), IsEmpty());
}

TEST(Rules, ConstructionsSpareLoads) {
  const std::string load = "[[stage]]\nkind = \"load\"\nx_m = [9.0, 10.5]\npressure_pa = 1e3\n";
  EXPECT_THAT(errors_of(built(load + dig)), Contains(HasSubstr("'pit' lies where the load 'load' acts")));
  EXPECT_THAT(errors_of(built(load + bank)), IsEmpty());
  EXPECT_THAT(errors_of(built(dig + load)), Contains(HasSubstr("reaches over a wall")));
}

/// The flat case with pores, water at -2 m, and stages that change it.
std::string with_water(const std::string& stages) {
  std::string text = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n" + stages + "[[stage]]");
  text = with("poisson = 0.28\n[[region]]", "poisson = 0.28\nporosity = 0.4\npermeability = 1e-4\n[[region]]",
              text);
  text = with("[soil.sand]\nmodel = \"linear_elastic\"\ndensity = 1700.0",
              "[soil.sand]\nmodel = \"linear_elastic\"", text);
  return text + "[water]\nlevel = -2.0\n";
}

std::string falls(const std::string& name, const std::string& keys) {
  return "[[stage]]\nkind = \"water\"\nname = \"" + name + "\"\n" + keys + "\n";
}

TEST(Stages, ChangeTheWater) {
  const Case scene = parse_case(with_water(falls("low", "level = -6.0") + falls("back", "level = -3.0")));
  EXPECT_EQ(scene.water->level, -3.0);
  EXPECT_EQ(scene.water->still_wet, std::nullopt);
  ASSERT_EQ(scene.constructions.size(), 2u);
  EXPECT_EQ(scene.constructions[0].before.water->level, -2.0);
  EXPECT_EQ(scene.constructions[1].before.water->level, -6.0);
  EXPECT_EQ(scene.constructions[1].before.water->fluid.density, 1000.0);
  EXPECT_THAT(stages_text(scene), HasSubstr("low                 water         water table at y = -6 m"));
}

TEST(Stages, ThatLetWaterFallFastLeaveSoilWet) {
  const Case fast = parse_case(with_water(falls("low", "level = -6.0\ndrainage = \"undrained\"")));
  EXPECT_EQ(fast.water->still_wet, -2.0);
  const Case drained = parse_case(
      with_water(falls("low", "level = -6.0\ndrainage = \"undrained\"") + falls("later", "level = -6.0")));
  EXPECT_EQ(drained.water->still_wet, std::nullopt);
  EXPECT_EQ(drained.constructions[1].before.water->still_wet, -2.0);
}

TEST(Stages, ThatChangeTheWaterNeedSome) {
  EXPECT_THAT(errors_of(built(falls("low", "level = -6.0"))),
              Contains(HasSubstr("changes [water], which the case does not have")));
  EXPECT_THAT(errors_of(with_water(falls("low", ""))), Contains(HasSubstr("missing 'level'")));
  EXPECT_THAT(errors_of(with_water(falls("low", "level = -6.0\ndrainage = \"undrained\"") +
                                   "[[stage]]\nkind = \"load\"\nx_m = [8.0, 12.0]\npressure_pa = 1e3\n")),
              Contains(HasSubstr("the load 'load' is drained, and soil above the water has not drained")));
}

TEST(Stages, SaySoilBySoilWhatWaterDoes) {
  const std::string load = "[[stage]]\nkind = \"load\"\nx_m = [8.0, 12.0]\npressure_pa = 1e3\n";
  const Case scene = parse_case(with_water(load + "drainage = { sand = \"undrained\" }\n"));
  EXPECT_TRUE(scene.loads.front().undrained);
  EXPECT_THAT(scene.loads.front().undrained_soils(), ElementsAre("sand"));
  EXPECT_THAT(stages_text(scene), HasSubstr("s of relaxation, undrained in 'sand', then until at rest"));
  EXPECT_FALSE(parse_case(with_water(load + "drainage = { sand = \"drained\" }\n")).loads.front().undrained);
  EXPECT_THAT(errors_of(with_water(load + "drainage = { sand = \"undraned\" }\n")),
              ElementsAre(HasSubstr("'drainage' = \"undraned\" is not known, did you mean 'undrained'?")));
  EXPECT_THAT(
      errors_of(with_water(load + "drainage = [\"sand\"]\n")),
      ElementsAre(HasSubstr("'drainage' must be a string, or table { NAME = string }, found an array")));
  EXPECT_THAT(errors_of(with_water(falls("low", "level = -6.0\ndrainage = { sand = \"undrained\" }"))),
              ElementsAre(HasSubstr("of kind \"water\" must be \"drained\" or \"undrained\" for all soils")));
  EXPECT_THAT(errors_of(with_water(falls("low", "level = -6.0\ndrainage = \"undrained\"") + load +
                                   "drainage = { sand = \"undrained\" }\n")),
              Contains(HasSubstr("make all of the load undrained")));
}

TEST(Rules, DrainageIsOfSoils) {
  const std::string load = "[[stage]]\nkind = \"load\"\nx_m = [8.0, 12.0]\npressure_pa = 1e3\ndrainage = ";
  EXPECT_THAT(errors_of(with_water(load + "{ sand = \"undrained\" }\n")), IsEmpty());
  EXPECT_THAT(errors_of(with_water(load + "{ snd = \"undrained\" }\n")),
              ElementsAre(HasSubstr("[[stage]] no soil has the name 'snd', did you mean 'sand'?")));
  EXPECT_THAT(errors_of(with("level = -2.0", "level = -20.0", with_water(load + "{ sand = \"drained\" }\n"))),
              ElementsAre(HasSubstr("soil 'sand' does not lie below water in the stage 'load'")));
  EXPECT_THAT(errors_of(with("permeability = 1e-4", "drainage = \"drained\"",
                             with_water(load + "{ sand = \"undrained\" }\n"))),
              ElementsAre(HasSubstr("soil 'sand' has a drainage of its own, \"drained\"")));
}

const std::string on_block = "[[stage]]\nkind = \"load\"\nname = \"crane\"\nstructure = \"block\"\n";

TEST(Loads, ActOnStructures) {
  const std::string build = stage("build", "remove = [\"pit\"]\nplace = [\"block\"]");
  const std::string force = "force_n_per_m = [5e3, -80e3]\n";
  const Case scene = parse_case(built(build + on_block + force, block));
  ASSERT_EQ(scene.loads.size(), 1u);
  EXPECT_TRUE(scene.loads.front().on_structure());
  EXPECT_EQ(scene.loads.front().force.y, -80e3);
  EXPECT_THAT(stages_text(scene),
              HasSubstr("force of [5000, -80000] N/m on the structure 'block', which stays; grows in"));
  EXPECT_THAT(errors_of(built(build + on_block, block)),
              ElementsAre(HasSubstr("missing 'force_n_per_m' = [fx, fy]: what acts on the structure")));
  EXPECT_THAT(errors_of(built(build + on_block + force + "pressure_pa = 1e3\n", block)),
              ElementsAre(HasSubstr("'pressure_pa' is of a load on the surface, and this one is on the "
                                    "structure 'block'")));
  EXPECT_THAT(errors_of(built("[[stage]]\nkind = \"load\"\nx_m = [9.0, 10.5]\npressure_pa = 1e3\n" + force)),
              ElementsAre(HasSubstr("'force_n_per_m' is of a load on a structure: give 'structure'")));
}

TEST(Rules, LoadsFindStructures) {
  const std::string build = stage("build", "remove = [\"pit\"]\nplace = [\"block\"]");
  const std::string load = on_block + "force_n_per_m = [0.0, -80e3]\n";
  EXPECT_THAT(errors_of(built(build + load, block)), IsEmpty());
  EXPECT_THAT(errors_of(built(load + build, block)),
              ElementsAre(HasSubstr("the structure 'block' does not stand in the stage 'crane'")));
  EXPECT_THAT(errors_of(built(build + with("\"block\"", "\"blok\"", load), block)),
              ElementsAre(HasSubstr("no [[structure]] has the name 'blok', did you mean 'block'?")));
  EXPECT_THAT(errors_of(built(build + load + stage("clear", "remove = [\"block\"]"), block)),
              ElementsAre(HasSubstr("'block' carries the load 'crane', which stays")));
}

TEST(Rules, LoadsActBesideStructures) {
  const auto load = [](const std::string& ends) {
    return "[[stage]]\nkind = \"load\"\nx_m = " + ends + "\npressure_pa = 1e3\n";
  };
  const std::string build = stage("build", "remove = [\"pit\"]\nplace = [\"block\"]");
  EXPECT_THAT(errors_of(built(build + load("[10.0, 11.0]"), block)), IsEmpty());
  EXPECT_THAT(errors_of(built(build + load("[9.0, 11.0]"), block)),
              Contains(HasSubstr("lies where the structure 'block' is, from x = 6 to 10 m")));
}

} // namespace
} // namespace tremolo::scene::testing
