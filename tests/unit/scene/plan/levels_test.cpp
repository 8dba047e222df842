// [[refine]]: what is read, what is refused and where, and the levels that follow.

#include "tests/unit/scene/case_text.hpp"

#include "scene/plan/plan.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace tremolo::scene::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// The flat case, 20 m x 10 m of 1 m cells, with [[refine]] from line 31 on.
std::string refined(std::string_view keys) {
  return plus("[[refine]]\n" + std::string(keys) + "\n");
}

TEST(Refine, IsRead) {
  const auto scene = parse_case(refined("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 2"));
  ASSERT_EQ(scene.mesh.refine.size(), 1U);
  EXPECT_EQ(scene.mesh.refine[0].level, 2);
  EXPECT_EQ(scene.mesh.refine[0].box.y_min, -4.0);
}

TEST(Rules, RefinementsSuitMesh) {
  const auto errors = [](std::string_view keys) { return errors_of(refined(keys)); };
  EXPECT_THAT(errors("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 0"),
              ElementsAre("case.toml:33:9: [[refine]] 'level' = 0 is out of range, must be in [1, 8]"));
  EXPECT_THAT(errors("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 1.5"),
              ElementsAre("case.toml:33:9: [[refine]] 'level' must be an integer, found a number"));
  EXPECT_THAT(errors("level = 1"), ElementsAre(HasSubstr("case.toml:31:1: [[refine]] missing 'box'")));
  EXPECT_THAT(errors("box = [5.0, -4.0, 15.0]\nlevel = 1"),
              ElementsAre(HasSubstr("case.toml:32:7: [[refine]] 'box'")));
  EXPECT_THAT(errors("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 1\nsize = 0.5"),
              ElementsAre(HasSubstr("case.toml:34:1: [[refine]] unknown key 'size'")));
  EXPECT_THAT(
      errors("box = [15.0, -4.0, 5.0, 0.0]\nlevel = 1"),
      ElementsAre("case.toml:32:7: [[refine]] 'box' is -10 m wide and 4 m high, must be [x_min, y_min, "
                  "x_max, y_max] with both > 0"));
  EXPECT_THAT(errors("box = [25.0, -4.0, 35.0, 0.0]\nlevel = 1"),
              ElementsAre("case.toml:32:7: [[refine]] 'box' lies beside the mesh, x 0 to 20 and y -10 to 0: "
                          "nothing is refined"));
  EXPECT_THAT(
      errors_of(with("size = 1.0", "size = 0.05", refined("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 8"))),
      ElementsAre("case.toml:33:9: [[refine]] 'level' = 8 makes cells of 0.0001953125 m, of which the "
                  "model would hold 5.24e+09, must be at most 1e+09"));
}

TEST(Refine, AFixedStepIsThatOfTheFinestCells) {
  EXPECT_THAT(
      errors_of(refined("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 1") + "[time]\ndt = 2e-3\n"),
      ElementsAre(HasSubstr("[time] 'dt' = 0.002 exceeds the critical step 0.65 h/c_p = 0.00187388 s")));
}

TEST(Rules, SubcyclingGoesWithLevels) {
  const std::string levels = "box = [5.0, -4.0, 15.0, 0.0]\nlevel = 1\n";
  EXPECT_THAT(errors_of(refined(levels + "[time]\nsubcycle = true")), ::testing::IsEmpty());
  EXPECT_FALSE(parse_case(refined(levels)).time.subcycle);
  EXPECT_THAT(errors_of(plus("[time]\nsubcycle = true\n")),
              ElementsAre("case.toml:32:12: [time] 'subcycle' = true does not go with cells of one size: it "
                          "gives levels steps of their own; add [[refine]], or leave it out"));
  EXPECT_THAT(
      errors_of(with("right = { model = \"wave\"", "right = { model = \"wave\", absorber = \"matched_layer\"",
                     refined(levels + "[time]\nsubcycle = true"))),
      ::testing::IsEmpty());
}

TEST(Boxes, FollowTheSoilWhereAsked) {
  const auto boxes = [](const std::string& kind, const std::string& text) {
    return with("size = 1.0", "size = 1.0\nparticle_boxes = \"" + kind + "\"", text);
  };
  const std::string flat(flat_case);
  const auto is_planned = [](const Case& scene) {
    const Plan of_scene = plan(scene);
    return std::ranges::find(of_scene.effects, "deforming boxes", &Effect::name)->on;
  };
  const Case scene = parse_case(boxes("deforming", flat));
  EXPECT_EQ(scene.mesh.particle_boxes, ParticleBoxes::deforming);
  EXPECT_TRUE(is_planned(scene));
  EXPECT_EQ(parse_case(flat).mesh.particle_boxes, ParticleBoxes::fixed);
  EXPECT_FALSE(is_planned(parse_case(flat)));
}

/// Springs tie particles in pairs.
TEST(Rules, SpringsTieEqualCells) {
  const auto springs = [](const std::string& box, const std::string& level) {
    return with("left = { model = \"wave\" }\nright = { model = \"wave\" }\n",
                "sides = \"periodic_springs\"\n", refined("box = " + box + "\nlevel = " + level));
  };
  EXPECT_THAT(errors_of(springs("[5.0, -4.0, 15.0, 0.0]", "1")), ::testing::IsEmpty());
  EXPECT_THAT(errors_of(springs("[-5.0, -4.0, 25.0, 0.0]", "2")), ::testing::IsEmpty());
  EXPECT_THAT(
      errors_of(springs("[0.0, -4.0, 15.0, 0.0]", "1")),
      ElementsAre("case.toml:25:9: [boundary] sides = \"periodic_springs\" tie particles of the left "
                  "side to those of the right, but from y = -4 on cells are 0.5 m at the left and 1 m "
                  "at the right; refine both sides alike, or use sides = \"periodic\""));
  // Cut for the balance alone.
  EXPECT_THAT(errors_of(springs("[5.0, -4.0, 19.0, 0.0]", "2")),
              ElementsAre(HasSubstr("from y = -5 on cells are 1 m at the left and 0.5 m at the right")));
  EXPECT_THAT(errors_of(with("periodic_springs", "periodic", springs("[0.0, -4.0, 15.0, 0.0]", "1"))),
              ::testing::IsEmpty());
}

TEST(Subcycle, TheStepIsThatOfTheCoarsestCells) {
  const auto text = refined("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 1\n[time]\nsubcycle = true");
  const auto scene = parse_case(text);
  const Plan whole = plan(scene);
  EXPECT_NEAR(whole.critical_dt, 3.7477e-3, 1e-7);
  EXPECT_EQ(whole.steps, 1068);
  EXPECT_EQ(whole.levels[1].dt, 0.5 * whole.dt);
  EXPECT_THAT(explain(scene, whole),
              HasSubstr("particles of 0.25 m, critical step 0.001874 s, 2 steps of 0.0009369 s\n"));
  EXPECT_THAT(errors_of(text + "dt = 3e-3\n"), ::testing::IsEmpty());
  EXPECT_THAT(errors_of(text + "dt = 4e-3\n"), ElementsAre(HasSubstr("exceeds the critical step")));
}

TEST(Levels, OfAUniformMeshThereIsOne) {
  const auto all = levels(parse_case(std::string(flat_case)));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].particles, 800.0);
}

TEST(Levels, HoldCellsParticlesAndCriticalSteps) {
  const auto scene = parse_case(refined("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 1"));
  const auto all = levels(scene);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].cells, 200.0 - 40.0);
  EXPECT_EQ(all[0].particles, 4.0 * 160.0);
  EXPECT_EQ(all[1].cells, 4.0 * 40.0);
  EXPECT_EQ(all[1].particles, 16.0 * 40.0);
  EXPECT_EQ(all[1].particle_size, 0.25);
  EXPECT_NEAR(all[0].critical_dt, 2.0 * all[1].critical_dt, 1e-12);
  EXPECT_NEAR(plan(scene).critical_dt, 3.7477e-3 / 2.0, 1e-7);
  EXPECT_THAT(
      explain(scene, plan(scene)),
      HasSubstr("    level 1  160 cells of 0.5 m, 640 particles of 0.25 m, critical step 0.001874 s\n"));
  const auto uniform = parse_case(std::string(flat_case));
  EXPECT_THAT(explain(uniform, plan(uniform)), Not(HasSubstr("level 0")));
}

/// Neighbours differ by one level, so a box two levels finer is surrounded by cells of the level between.
TEST(Levels, CellsAroundABoxAreCutForTheBalance) {
  const auto all = levels(parse_case(refined("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 2")));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[2].cells, 16.0 * 40.0);
  EXPECT_EQ(all[1].cells, 4.0 * (12.0 * 5.0 - 40.0));
  EXPECT_EQ(all[0].cells, 200.0 - 60.0);
}

/// Stiff soil that no fine cell touches does not hold the step down.
TEST(Levels, TheStepOfALevelIsThatOfTheSoilInIt) {
  auto text = with("[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]",
                   "[[0.0, -8.0], [20.0, -8.0], [20.0, 0.0], [0.0, 0.0]]",
                   refined("box = [5.0, -4.0, 15.0, 0.0]\nlevel = 1"));
  text += "[soil.rock]\nmodel = \"linear_elastic\"\ndensity = 1700.0\nyoung = 160e6\npoisson = 0.28\n"
          "[[region]]\nsoil = \"rock\"\npolygon = [[0.0, -10.0], [20.0, -10.0], [20.0, -8.0], [0.0, -8.0]]\n";
  const auto all = levels(parse_case(text));
  EXPECT_NEAR(all[0].critical_dt, 3.7477e-3 / 2.0, 1e-7);
  EXPECT_NEAR(all[1].critical_dt, 3.7477e-3 / 2.0, 1e-7);
}

} // namespace
} // namespace tremolo::scene::testing
