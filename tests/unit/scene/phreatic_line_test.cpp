// Water that is not level in a case: a phreatic line, and levels that water seeps between.

#include "case_text.hpp"

#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/wet_soils.hpp"
#include "scene/soils/ground_column.hpp"
#include "scene/soils/water_table.hpp"

#include <gmock/gmock.h>

#include <string>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Ground that falls from y = 0 at the left to y = -4 m at the right, of sand with pores, under gravity.
std::string slope(const std::string& water) {
  std::string text = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]");
  text = with("model = \"linear_elastic\"\ndensity = 1700.0\n",
              "model = \"linear_elastic\"\nporosity = 0.4\npermeability = 1e-4\n", text);
  text = with("[20.0, 0.0], [0.0, 0.0]]", "[20.0, -4.0], [12.0, -4.0], [8.0, 0.0], [0.0, 0.0]]", text);
  text = with("right = { model = \"wave\" }", "right = { model = \"fe\", surface = -4.0 }", text);
  text = with("left = { model = \"wave\" }", "left = { model = \"fe\" }", text);
  text = with("base = { model = \"wave\", form = \"total\" }",
              "base = { model = \"fe\", form = \"incident\" }", text);
  return with("[[region]]", water + "[[profile]]\nthickness = 6.0\nsoil = \"sand\"\n[[region]]", text);
}

const std::string line = "[water]\nline = [[0.0, -2.0], [10.0, -3.0], [20.0, -4.5]]\n";
const std::string seepage = "[water]\nseepage = true\nleft = -2.0\nright = -3.5\n";

TEST(PhreaticLine, GivesEachPlaceItsTable) {
  const Case scene = parse_case(slope(line));
  ASSERT_TRUE(scene.water);
  EXPECT_FALSE(scene.water->is_level());
  EXPECT_EQ(scene.water->beside(Side::left), -2.0);
  EXPECT_EQ(scene.water->beside(Side::right), -4.5);
  EXPECT_DOUBLE_EQ(table_at(scene, 5.0), -2.5);
  EXPECT_DOUBLE_EQ(table_at(scene, 10.0), -3.0);
  EXPECT_DOUBLE_EQ(table_at(scene, 18.0), -4.2);
  EXPECT_DOUBLE_EQ(table_at(scene, 25.0), -4.5);
  // 2.5 m of dry ground, 5 m under water.
  EXPECT_NEAR(vertical_stress(scene, ground_of_domain(scene, 5.0), -7.5), 9.81 * (1590.0 * 2.5 + 990.0 * 5.0),
              1e-6);
}

TEST(PhreaticLine, GivesTheFreeFieldOfEachSideItsOwnTable) {
  const Case scene = parse_case(slope(line));
  const Plan planned = plan(scene);
  EXPECT_EQ(water_level(scene, source_of(planned, Side::left)), -2.0);
  EXPECT_EQ(water_level(scene, source_of(planned, Side::right)), -4.5);
  const auto& left = layers(scene, scene.boundary.left);
  const auto& right = layers(scene, scene.boundary.right);
  ASSERT_EQ(left.size(), 2U);
  ASSERT_GE(right.size(), 2U);
  EXPECT_DOUBLE_EQ(left[0].thickness, 2.0);
  EXPECT_DOUBLE_EQ(right[0].thickness, 0.5); // below a surface at -4 m
  EXPECT_FALSE(right[0].wet);
  EXPECT_TRUE(right.back().wet);
  const std::string text = explain(scene, planned);
  EXPECT_THAT(text, AllOf(HasSubstr("water table at y = -2 m"), HasSubstr("water table at y = -4.5 m")));
}

TEST(PhreaticLine, SaysHowFarItIsFromFlow) {
  // tan(b) = 0.15: pressures are 1/cos^2(b) = 1 + tan^2(b) as high as along a slope.
  EXPECT_THAT(water_text(parse_case(slope(line))),
              AllOf(HasSubstr("phreatic line from y = -2 m at the left to y = -4.5 m at the right"),
                    HasSubstr("(8.53 degrees), pressures are 2.25 % higher"), HasSubstr("seepage = true")));
}

TEST(FreeWater, IsSaidToPressAsAtRest) {
  const auto told = HasSubstr("free water over the ground presses on it as at rest");
  EXPECT_THAT(water_text(parse_case(slope("[water]\nlevel = -4.5\n"))), Not(told));
  EXPECT_THAT(water_text(parse_case(slope(line))), told); // before the toe
  EXPECT_THAT(water_text(parse_case(slope("[water]\nlevel = -3.0\n"))), told);
  EXPECT_THAT(water_text(parse_case(slope("[water]\nline = [[0.0, -2.0], [20.0, -3.5]]\n"))), told);
  EXPECT_THAT(water_text(parse_case(slope(seepage))), told);
}

TEST(PhreaticLine, ThatIsLevelIsATable) {
  const Case scene = parse_case(slope("[water]\nline = [[0.0, -4.5], [20.0, -4.5]]\n"));
  EXPECT_TRUE(scene.water->is_level());
  EXPECT_EQ(scene.water->level, -4.5);
  EXPECT_TRUE(parse_case(slope("[water]\nseepage = true\nleft = -4.5\nright = -4.5\n")).water->is_level());
}

TEST(Rules, PhreaticLineSpansModel) {
  const auto told = [](const std::string& corners) {
    return errors_of(slope("[water]\nline = " + corners + "\n"));
  };
  EXPECT_THAT(
      told("[[0.0, -2.0], [15.0, -4.0]]"),
      ElementsAre(AllOf(HasSubstr("case.toml:"),
                        HasSubstr("'line' goes from x = 0 to 15 m, and the model from x = 0 to 20 m"))));
  EXPECT_THAT(told("[[0.0, -2.0], [10.0, -3.0], [10.0, -4.0], [20.0, -4.5]]"),
              ElementsAre(HasSubstr("corner 3 of 'line', x = 10 m, does not lie to the right of corner 2")));
  EXPECT_THAT(told("[[0.0, -2.0], [20.0, -11.0]]"),
              ElementsAre(HasSubstr("below the base of the model at y = -10 m")));
  EXPECT_THAT(told("[[0.0, -2.0]]"), ElementsAre(HasSubstr("'line' must be an array of at least 2 points")));
}

TEST(Water, SaysOnceWhereItIs) {
  EXPECT_THAT(errors_of(slope("[water]\n")), Contains(HasSubstr("missing 'level'")));
  EXPECT_THAT(errors_of(slope("[water]\nlevel = -2.0\nline = [[0.0, -2.0], [20.0, -4.5]]\n")),
              ElementsAre(HasSubstr("'line' and 'level' exclude each other")));
  EXPECT_THAT(errors_of(slope(seepage + "level = -2.0\n")),
              ElementsAre(HasSubstr("'level' is of water at rest")));
  EXPECT_THAT(errors_of(slope("[water]\nseepage = true\nleft = -2.0\n")),
              Contains(HasSubstr("missing 'right'")));
  EXPECT_THAT(errors_of(slope("[water]\nlevel = -2.0\nleft = -2.0\n")),
              ElementsAre(HasSubstr("'left' does not apply")));
}

TEST(Rules, SeepageCanBeFound) {
  EXPECT_THAT(errors_of(slope(seepage)), IsEmpty());
  EXPECT_THAT(errors_of(with("permeability = 1e-4\n", "drainage = \"undrained\"\n", slope(seepage))),
              ElementsAre(HasSubstr("missing 'permeability': with [water] seepage = true")));
  EXPECT_THAT(errors_of(with("left = -2.0", "left = 1.0", slope(seepage))),
              ElementsAre(HasSubstr("would meet over the ground, which rises to y = 0 m")));
  EXPECT_THAT(errors_of(with("right = -3.5", "right = -10.5", slope(seepage))),
              ElementsAre(HasSubstr("'right' = -10.5 m does not lie above the base")));
}

// A line stays while the ground under it changes; flow is found anew.
TEST(Seepage, GoesWithConstruction) {
  const auto built = [](const std::string& water) {
    const std::string fill =
        "[[region]]\nsoil = \"sand\"\nname = \"fill\"\npolygon = [[2.0, 0.0], [6.0, 0.0], "
        "[5.0, 1.0], [3.0, 1.0]]\n";
    std::string text =
        with("box = [0.0, -10.0, 20.0, 0.0]", "box = [0.0, -10.0, 20.0, 2.0]", slope(water) + fill);
    return errors_of(
        with("[[stage]]\nkind = \"shaking\"",
             "[[stage]]\nkind = \"construction\"\nname = \"bank\"\nplace = [\"fill\"]\n[[stage]]\nkind "
             "= \"shaking\"",
             text));
  };
  EXPECT_THAT(built(line), IsEmpty());
  EXPECT_THAT(built(seepage), IsEmpty());
}

TEST(Rules, WaterSuitsSides) {
  const auto between = [](const std::string& sides, const std::string& water) {
    std::string text = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]");
    text = with("model = \"linear_elastic\"\ndensity = 1700.0\n",
                "model = \"linear_elastic\"\nporosity = 0.4\npermeability = 1e-4\n", text);
    text = with("left = { model = \"wave\" }\nright = { model = \"wave\" }\n", "sides = \"" + sides + "\"\n",
                text);
    return errors_of(with("[[region]]", water + "[[region]]", text));
  };
  EXPECT_THAT(
      between("periodic", "[water]\nline = [[0.0, -2.0], [20.0, -4.5]]\n"),
      ElementsAre(AllOf(HasSubstr("y = -2 m at the left side and at -4.5 m"), HasSubstr("one level"))));
  EXPECT_THAT(between("periodic", "[water]\nline = [[0.0, -2.0], [10.0, -4.0], [20.0, -2.0]]\n"), IsEmpty());
}

TEST(Water, ThatIsNotLevelCostsBytesOfItsHead) {
  const auto on = [](const std::string& water) {
    for (const Effect& effect : plan(parse_case(slope(water))).effects)
      if (effect.name == "seepage force")
        return effect.on ? effect.bytes_per_particle : -1.0;
    return 0.0;
  };
  EXPECT_EQ(on("[water]\nlevel = -4.5\n"), -1.0);
  EXPECT_EQ(on(line), 24.0);
}

} // namespace
} // namespace tremolo::scene::testing
