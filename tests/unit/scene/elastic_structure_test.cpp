// Elastic structures: their keys, their rules, and what the plan makes of them.

#include "structure_case.hpp"

#include "scene/plan/plan.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// The block with other keys than `rigid`.
std::string block(std::string_view keys) {
  return with("rigid = true", keys, with_block());
}

TEST(ElasticStructure, IsRead) {
  const Case scene = parse_case(block("young = 20e6\npoisson = 0.2"));
  const auto& stiffness = scene.structures.at(0).stiffness;
  ASSERT_TRUE(stiffness);
  EXPECT_EQ(stiffness->young, 20e6);
  EXPECT_EQ(stiffness->poisson, 0.2);
  EXPECT_FALSE(parse_case(with_block()).structures.at(0).stiffness);
}

TEST(ElasticStructure, WrongKeysAreRefusedWhereTheyStand) {
  EXPECT_THAT(errors_of(block("")),
              ElementsAre(HasSubstr("case.toml:33:1: [[structure]] missing 'rigid' = true, or 'young' and "
                                    "'poisson' of an elastic structure")));
  EXPECT_THAT(errors_of(block("rigid = false")),
              ElementsAre("case.toml:37:9: [[structure]] 'rigid' = false: give 'young' and 'poisson' in its "
                          "place"));
  EXPECT_THAT(
      errors_of(block("rigid = true\nyoung = 20e6\npoisson = 0.2")),
      ElementsAre("case.toml:37:9: [[structure]] 'rigid' and 'young' exclude each other: remove one"));
  EXPECT_THAT(errors_of(block("young = 20e6")),
              ElementsAre("case.toml:33:1: [[structure]] missing 'poisson': 'young' needs it"));
  EXPECT_THAT(errors_of(block("poisson = 0.2")),
              ElementsAre("case.toml:33:1: [[structure]] missing 'young': 'poisson' needs it"));
  EXPECT_THAT(errors_of(block("yuong = 20e6\npoisson = 0.2")),
              Contains("case.toml:37:1: [[structure]] unknown key 'yuong', did you mean 'young'?"));
  EXPECT_THAT(errors_of(block("young = 0.0\npoisson = 0.5")),
              ElementsAre("case.toml:37:9: [[structure]] 'young' = 0 is out of range, must be > 0 Pa",
                          HasSubstr("case.toml:38:11: [[structure]] 'poisson' = 0.5 is out of range")));
}

/// Elastic structures may stand beside each other and beside rigid ones, and on them.
TEST(Rules, ElasticStructuresMeetOthers) {
  const auto second = [](std::string_view polygon, std::string_view kind) {
    return block("young = 20e6\npoisson = 0.2") +
           "[[structure]]\nname = \"wall\"\npolygon = " + std::string(polygon) + "\ndensity = 1000.0\n" +
           std::string(kind) + "\nfriction = 0.5\n";
  };
  for (const std::string_view kind : {"rigid = true", "young = 1e7\npoisson = 0.2"})
    for (const std::string_view polygon : {"[[3.0, 0.0], [8.0, 0.0], [8.0, 4.0], [3.0, 4.0]]",
                                           "[[8.0, 4.0], [12.0, 4.0], [12.0, 8.0], [8.0, 8.0]]"})
      EXPECT_THAT(errors_of(second(polygon, kind)), IsEmpty()) << kind << polygon;
}

TEST(Rules, ElasticStructuresSuitWater) {
  const auto holed = [](std::string_view level) {
    std::string text =
        with("[soil.sand]",
             "[water]\nlevel = " + std::string(level) + "\n[soil.sand]\nporosity = 0.4\npermeability = 1e-4",
             block("hole = [[9.0, 1.0], [11.0, 1.0], [11.0, 3.0], [9.0, 3.0]]\nyoung = "
                   "20e6\npoisson = 0.2"));
    // Walls of a metre are two cells thick.
    return with("density = 1700.0\nyoung = 40e6\npoisson = 0.28\n[[region]]",
                "young = 40e6\npoisson = 0.28\n[[region]]", text) +
           "[[refine]]\nbox = [4.0, -4.0, 16.0, 0.0]\nlevel = 1\n";
  };
  EXPECT_THAT(errors_of(holed("-1.0")), IsEmpty());
  EXPECT_THAT(
      errors_of(holed("1.5")),
      Contains(HasSubstr("[[structure]] 'hole' reaches down to y = 1 m, below the water table at 1.5 m: "
                         "a structure with a hole there must be rigid")));
}

/// The soil's critical step goes with M/rho = 40e6/1700 * 0.72/(1.28*0.44) (m/s)2. With 1000 kg/m3 and nu =
/// 0.2, M = E/0.9, a structure has the same for E = 27.07 MPa.
TEST(Rules, StructuresLeaveTheStep) {
  const double step = plan(parse_case(with_block())).critical_dt;
  const std::string soft = block("young = 27.0e6\npoisson = 0.2");
  EXPECT_THAT(remarks_of(soft), Not(Contains(HasSubstr("sets the time step"))));
  EXPECT_DOUBLE_EQ(plan(parse_case(soft)).critical_dt, step);
  const std::string stiff = block("young = 108e6\npoisson = 0.2");
  EXPECT_THAT(remarks_of(stiff),
              Contains("case.toml:37:9: warning: [[structure]] 'young' = 1.08e+08 Pa sets the time step: its "
                       "critical step is 0.00188 s, that of the soil 0.00375 s; 2.7e+07 Pa would not, nor "
                       "would rigid = true"));
  const Case case_of_stiff = parse_case(stiff);
  const Plan plan_of_stiff = plan(case_of_stiff);
  EXPECT_NEAR(plan_of_stiff.critical_dt, 0.5 * step, 2e-3 * step);
  EXPECT_EQ(plan_of_stiff.limit.by, "structure 'block'");
  EXPECT_DOUBLE_EQ(plan_of_stiff.limit.others, step);
  EXPECT_THAT(explain(case_of_stiff, plan_of_stiff),
              HasSubstr("set by structure 'block' on cells of 1 m; 0.003748 s without it\n"));
}

TEST(Rules, ElasticStructuresBoundAFixedStep) {
  const std::string fixed = block("young = 108e6\npoisson = 0.2") + "[time]\ndt = 3e-3\n";
  EXPECT_THAT(errors_of(fixed),
              ElementsAre(HasSubstr("'dt' = 0.003 exceeds the critical step 0.65 h/c_p = "
                                    "0.00187639 s of this mesh and its elastic structures")));
  EXPECT_THAT(errors_of(with_block() + "[time]\ndt = 3e-3\n"), IsEmpty());
}

TEST(ElasticStructure, IsPlannedWithItsParticles) {
  const std::string text = block("young = 20e6\npoisson = 0.2");
  const Plan rigid = plan(parse_case(with_block()));
  const Plan elastic = plan(parse_case(text));
  EXPECT_EQ(elastic.particles, rigid.particles + 64U); // 16 m2, squares of 0.25 m2
  EXPECT_GT(elastic.memory_bytes, rigid.memory_bytes);
  EXPECT_THAT(explain(parse_case(text), elastic),
              HasSubstr("elastic, young 2e+07 Pa, poisson 0.2, 16 m2 of 1000 kg/m3"));
}

/// Walls of a metre, a quarter of the width, are no beams; those of half a metre on cells of half a metre
/// bend as solid on cells of 0.125 m: with nu = 0.2 and E = 400 MPa, c = sqrt(E/0.9/1000) = 667 m/s and the
/// critical step 0.65 h/c = 0.122 ms. The soil alone allows 0.65 0.25/173.5 = 0.937 ms.
TEST(ElasticStructure, ExplainSaysWhatALiningWouldSave) {
  const auto explained = [](std::string_view hole) {
    const Case scene = parse_case(block("hole = " + std::string(hole) + "\nyoung = 400e6\npoisson = 0.2") +
                                  "[[refine]]\nbox = [4.0, -4.0, 16.0, 0.0]\nlevel = 2\n");
    return explain(scene, plan(scene));
  };
  EXPECT_THAT(explained("[[9.0, 1.0], [11.0, 1.0], [11.0, 3.0], [9.0, 3.0]]"),
              Not(HasSubstr("a [[lining]] in its place")));
  EXPECT_THAT(
      explained("[[8.5, 0.5], [11.5, 0.5], [11.5, 3.5], [8.5, 3.5]]"),
      HasSubstr("    lining     a [[lining]] in its place bends on these cells with a critical step of "
                "0.000937 s; solid, it bends on cells of 0.125 m, with 0.000122 s\n"));
}

} // namespace
} // namespace tremolo::scene::testing
