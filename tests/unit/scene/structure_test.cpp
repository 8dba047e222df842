// [[structure]]: what its keys give, and what the plan makes of it.

#include "structure_case.hpp"

#include "scene/plan/plan.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A tunnel in the middle of the flat case.
constexpr std::string_view tunnel = "[[structure]]\nname = \"tunnel\"\n"
                                    "circle = { centre = [10.0, -5.0], radius = 2.5 }\n"
                                    "hole_circle = { centre = [10.0, -5.0], radius = 2.0 }\n"
                                    "density = 2400.0\nrigid = true\nfriction = 0.4\nadhesion = 2e3\n";

TEST(Structure, IsRead) {
  const Case scene = parse_case(with_block());
  ASSERT_EQ(scene.structures.size(), 1U);
  const Structure& block = scene.structures[0];
  EXPECT_EQ(block.name, "block");
  EXPECT_EQ(block.outline.key, "polygon");
  ASSERT_EQ(block.outline.corners.size(), 4U);
  EXPECT_EQ(block.outline.corners[2].y, 4.0);
  EXPECT_FALSE(block.hole);
  EXPECT_EQ(block.density, 1000.0);
  EXPECT_EQ(block.friction, 0.5);
  ASSERT_EQ(block.against.size(), 1U);
  EXPECT_EQ(block.against[0].friction, 0.5);
  EXPECT_EQ(block.against[0].adhesion, 0.0);
  EXPECT_EQ(scene.mesh.contact_normals, ContactNormals::automatic);
  EXPECT_EQ(parse_case(with("size = 1.0", "size = 1.0\ncontact_normals = \"polygon\"", with_block()))
                .mesh.contact_normals,
            ContactNormals::polygon);
  EXPECT_THAT(parse_case(std::string(flat_case)).structures, IsEmpty());
}

TEST(Structure, IsAPolygonOfACirclesArea) {
  const Structure round = parse_case(heavy() + std::string(tunnel)).structures.at(0);
  EXPECT_EQ(round.outline.key, "circle");
  ASSERT_TRUE(round.hole);
  EXPECT_EQ(round.hole->key, "hole_circle");
  ASSERT_EQ(round.outline.corners.size(), 64U);
  EXPECT_NEAR(area(round.outline.corners), std::numbers::pi * 6.25, 1e-12);
  EXPECT_NEAR(area(round.hole->corners), std::numbers::pi * 4.0, 1e-12);
  for (const Point corner : round.outline.corners)
    EXPECT_NEAR(std::hypot(corner.x - 10.0, corner.y + 5.0), 2.5, 0.01);
  EXPECT_EQ(round.against.at(0).adhesion, 2e3);
}

TEST(Structure, HasItsOwnSurfaceAgainstASoil) {
  const std::string clay = "[soil.clay]\nmodel = \"linear_elastic\"\ndensity = 1700.0\nyoung = 40e6\n"
                           "poisson = 0.28\n";
  const auto against = [&](const std::string& tables) {
    return with("friction = 0.5", "friction = 0.5\nadhesion = 1e3\nagainst = [" + tables + "]",
                with_block()) +
           clay;
  };
  const Case scene = parse_case(against("{ soil = \"clay\", friction = 0.3, adhesion = 5e3 }"));
  const auto clay_at =
      static_cast<std::size_t>(std::ranges::find(scene.soils, "clay", &Soil::name) - scene.soils.begin());
  ASSERT_LT(clay_at, 2U);
  const Structure& block = scene.structures.at(0);
  EXPECT_EQ(block.against.at(clay_at).friction, 0.3);
  EXPECT_EQ(block.against.at(clay_at).adhesion, 5e3);
  EXPECT_EQ(block.against.at(1 - clay_at).friction, 0.5);
  EXPECT_EQ(block.against.at(1 - clay_at).adhesion, 1e3);
  EXPECT_EQ(block.friction, 0.5);
  // What a table leaves out is the structure's own.
  EXPECT_EQ(
      parse_case(against("{ soil = \"clay\", adhesion = 5e3 }")).structures[0].against[clay_at].friction,
      0.5);
  // Tables with headings of their own say the same.
  const std::string headed =
      with("friction = 0.5", "friction = 0.5\n[[structure.against]]\nsoil = \"clay\"\nfriction = 0.3",
           with_block()) +
      clay;
  EXPECT_EQ(parse_case(headed).structures.at(0).against.at(clay_at).friction, 0.3);

  EXPECT_THAT(errors_of(against("{ soil = \"clax\", friction = 0.3 }")),
              ElementsAre("case.toml:40:21: [[structure.against]] soil 'clax' is not defined, did you mean "
                          "'clay'?"));
  EXPECT_THAT(errors_of(against("{ soil = \"clay\", friction = 0.3 }, { soil = \"clay\", friction = 0.2 }")),
              ElementsAre(HasSubstr("[[structure.against]] soil 'clay' stands twice in 'against'")));
  EXPECT_THAT(errors_of(against("{ soil = \"clay\" }")),
              ElementsAre(HasSubstr("neither 'friction' nor 'adhesion' against soil 'clay'")));
  EXPECT_THAT(errors_of(against("{ friction = 0.3 }")), ElementsAre(HasSubstr("missing 'soil'")));
  EXPECT_THAT(errors_of(against("{ soil = \"clay\", frictoin = 0.3, adhesion = -1.0 }")),
              ElementsAre(HasSubstr("[[structure.against]] unknown key 'frictoin', did you mean 'friction'?"),
                          HasSubstr("'adhesion' = -1 is out of range, must be >= 0 Pa")));
  EXPECT_THAT(errors_of(with("friction = 0.5", "friction = 0.5\nagainst = 3", with_block())),
              ElementsAre("case.toml:39:11: [[structure.against]] 'structure.against' must be an array of "
                          "tables, found an integer: write [[structure.against]]"));
  EXPECT_THAT(errors_of(with("friction = 0.5", "friction = 0.5\nagainst = [3]", with_block())),
              ElementsAre(HasSubstr("each [[structure.against]] must be a table, found an integer")));
}

TEST(Structure, WrongKeysAreRefusedWhereTheyStand) {
  const auto block = [](std::string_view old, std::string_view by) {
    return errors_of(with(old, by, with_block()));
  };
  EXPECT_THAT(block("friction = 0.5\n", ""),
              ElementsAre(HasSubstr(
                  "case.toml:33:1: [[structure]] missing 'friction', number: Coefficient of friction")));
  EXPECT_THAT(block("density = 1000.0", "density = 0.0"),
              ElementsAre("case.toml:36:11: [[structure]] 'density' = 0 is out of range, must be > 0 kg/m3"));
  EXPECT_THAT(block("friction = 0.5", "friction = -0.5"),
              ElementsAre("case.toml:38:12: [[structure]] 'friction' = -0.5 is out of range, must be >= 0"));
  EXPECT_THAT(block("polygon = [[8.0, 0.0], [12.0, 0.0], [12.0, 4.0], [8.0, 4.0]]\n", ""),
              ElementsAre("case.toml:33:1: [[structure]] missing 'polygon' or 'circle': the outline of the "
                          "structure"));
  EXPECT_THAT(block("friction = 0.5", "friction = 0.5\ncircle = { centre = [10.0, 0.0], radius = 2.0 }"),
              ElementsAre(HasSubstr("'polygon' and 'circle' exclude each other: remove one")));
  const std::string round = heavy() + std::string(tunnel);
  EXPECT_THAT(
      errors_of(with("radius = 2.5", "radius = -2.5", round)),
      ElementsAre("case.toml:35:44: [structure.circle] 'radius' = -2.5 is out of range, must be > 0 m"));
  EXPECT_THAT(errors_of(with("radius = 2.5", "radus = 2.5", round)),
              ElementsAre("case.toml:35:10: [structure.circle] missing 'radius', number m: Its radius.",
                          "case.toml:35:35: [structure.circle] unknown key 'radus', did you mean 'radius'?"));
  EXPECT_THAT(errors_of(with("{ centre = [10.0, -5.0], radius = 2.5 }", "2.5", round)),
              ElementsAre("case.toml:35:10: [[structure]] 'circle' must be a table, found a number"));
}

TEST(Structure, IsPlannedByItsWeight) {
  const Case scene = parse_case(with_block());
  const Plan block = plan(scene);
  ASSERT_EQ(block.structures.size(), 1U);
  EXPECT_DOUBLE_EQ(block.structures[0].mass, 16000.0);
  EXPECT_DOUBLE_EQ(block.structures[0].weight, 156960.0);
  EXPECT_EQ(block.structures[0].buoyancy, 0.0);
  EXPECT_EQ(block.structures[0].contact_nodes, 5.0); // a base of 4 m on cells of 1 m
  const auto contact = std::ranges::find(block.effects, "contact", &Effect::name);
  ASSERT_NE(contact, block.effects.end());
  EXPECT_TRUE(contact->on);
  EXPECT_EQ(contact->why,
            "1 structure: 'block' 16000 kg/m, 157 kN/m; about 5 contact nodes (9 kB, about 15 us "
            "a step); soil elsewhere pays nothing");
  EXPECT_EQ(block.particles, plan(parse_case(heavy())).particles);
  EXPECT_THAT(explain(scene, block),
              AllOf(HasSubstr("rigid, 16 m2 of 1000 kg/m3: 16000 kg/m, 157 kN/m; about 5 contact nodes"),
                    HasSubstr("'sand' friction 0.5")));
  const auto json = nlohmann::json::parse(to_json(scene, block));
  EXPECT_EQ(json.at("structures").at(0).at("name"), "block");
  EXPECT_EQ(json.at("structures").at(0).at("mass_kg_per_m"), 16000.0);

  const Plan flat = plan(parse_case(heavy()));
  EXPECT_EQ(block.memory_bytes - flat.memory_bytes, block.structures[0].bytes);
  EXPECT_NEAR(block.estimated_time - flat.estimated_time, static_cast<double>(flat.steps) * 15e-6, 1e-9);
  EXPECT_FALSE(std::ranges::find(flat.effects, "contact", &Effect::name)->on);
  EXPECT_FALSE(nlohmann::json::parse(to_json(parse_case(heavy()), flat)).contains("structures"));
  EXPECT_THAT(explain(parse_case(heavy()), flat), Not(HasSubstr("\nStructures\n")));
}

/// A tunnel of 5 m below the table: 1000 kg/m3 * 9.81 m/s2 * pi 2.5^2 m2 = 192.6 kN/m of water.
TEST(Structure, IsPlannedByWhatWaterLifts) {
  std::string text =
      with("[soil.sand]", "[water]\nlevel = -1.0\n[soil.sand]\nporosity = 0.4\npermeability = 1e-4",
           heavy() + std::string(tunnel));
  text = with("density = 1700.0\nyoung = 40e6\npoisson = 0.28\n[[region]]",
              "young = 40e6\npoisson = 0.28\n[[region]]", text);
  text = with("density = 2400.0", "density = 1000.0", text);
  const Plan planned = plan(parse_case(text));
  const PlannedStructure& tube = planned.structures.at(0);
  EXPECT_NEAR(tube.buoyancy, 9810.0 * std::numbers::pi * 6.25, 1e-6);
  EXPECT_NEAR(tube.weight, 9810.0 * std::numbers::pi * 2.25, 1e-6);
  EXPECT_THAT(std::ranges::find(planned.effects, "contact", &Effect::name)->why,
              HasSubstr("69.34 kN/m, net 123.3 kN/m upwards in water"));
}

/// Squares that structures take whole carry no particle: 0.25 m2 each, and a quarter of it in finer cells.
TEST(Structure, TakesThePlaceOfSoil) {
  const auto particles = [](const std::string& text) { return plan(parse_case(text)).particles; };
  const std::size_t all = particles(heavy());
  const std::string buried = with("[[8.0, 0.0], [12.0, 0.0], [12.0, 4.0], [8.0, 4.0]]",
                                  "[[8.0, -2.0], [12.0, -2.0], [12.0, 1.0], [8.0, 1.0]]", with_block());
  EXPECT_EQ(particles(buried), all - 32U); // 4 m by 2 m
  const std::string refined = "[[refine]]\nbox = [4.0, -8.0, 16.0, 0.0]\nlevel = 1\n";
  EXPECT_EQ(particles(buried + refined), particles(heavy() + refined) - 128U);
}

} // namespace
} // namespace tremolo::scene::testing
