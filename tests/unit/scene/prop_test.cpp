// Props: their keys, the stages that they take part in, and what the plan says of them.

#include "prop_case.hpp"

#include "scene/plan/plan.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Prop, IsRead) {
  const Case scene = parse_case(prop_with("stiffness = 2e6", "stiffness = 2e6\nprestress = 1e5\nyield = 4e5\n"
                                                             "bears = \"tension\""));
  const Prop& prop = scene.props.at(0);
  EXPECT_EQ(prop.name, "anchor");
  EXPECT_EQ(prop.from.structure, "block");
  EXPECT_EQ(prop.from.position.y, 2.0);
  EXPECT_EQ(prop.to.structure, "");
  EXPECT_EQ(prop.to.position.x, 4.0);
  EXPECT_EQ(prop.stiffness, 2e6);
  EXPECT_EQ(prop.prestress, 1e5);
  EXPECT_EQ(prop.yield, 4e5);
  EXPECT_EQ(prop.bears, mpm_domain::Bears::tension);
  const Case plain = parse_case(with_prop());
  EXPECT_FALSE(plain.props.at(0).prestress);
  EXPECT_FALSE(plain.props.at(0).yield);
  EXPECT_EQ(plain.props.at(0).bears, mpm_domain::Bears::both);
}

TEST(Prop, WrongKeysAreRefusedWhereTheyStand) {
  EXPECT_THAT(
      errors_of(with_prop("stiffness = 2e6\nfrom = { structure = \"block\", at = [8.0, 2.0] }")),
      ElementsAre(HasSubstr("[[prop]] missing 'to = { structure = \"NAME\", at = [x, y] }' of the prop")));
  EXPECT_THAT(errors_of(prop_with("structure = \"block\", at", "structure = \"blok\", at")),
              Contains(HasSubstr("structure 'blok' is not defined, did you mean 'block'?")));
  EXPECT_THAT(errors_of(prop_with("stiffness = 2e6", "stiffness = -2e6")),
              ElementsAre(HasSubstr("'stiffness' = -2000000 is out of range, must be > 0 N/m2")));
  EXPECT_THAT(errors_of(prop_with("stiffness = 2e6", "stifness = 2e6")),
              Contains(HasSubstr("unknown key 'stifness', did you mean 'stiffness'?")));
}

TEST(Prop, TakesPartInStagesByItsName) {
  const std::string stages = "[[stage]]\nkind = \"construction\"\nname = \"tie\"\nplace = [\"anchor\"]\n"
                             "[[stage]]\nkind = \"construction\"\nname = \"untie\"\nremove = [\"anchor\"]\n";
  const Case scene = parse_case(
      with("[[stage]]\nkind = \"shaking\"", stages + "[[stage]]\nkind = \"shaking\"", with_prop()));
  EXPECT_TRUE(scene.props.empty());
  ASSERT_EQ(scene.constructions.size(), 2U);
  EXPECT_TRUE(scene.constructions[0].before.props.empty());
  EXPECT_EQ(scene.constructions[1].before.props.at(0).name, "anchor");
}

TEST(Prop, IsInThePlan) {
  const Case scene = parse_case(with_prop());
  const Plan made = plan(scene);
  const std::string text = explain(scene, made);
  EXPECT_THAT(text,
              HasSubstr("anchor            from 'block' at (8, 2) to the ground at (4, -3) m, 6.403 m long"));
  EXPECT_THAT(text, HasSubstr("bears tension and compression; allows steps of about"));
  const auto json = nlohmann::json::parse(to_json(scene, made));
  EXPECT_EQ(json["props"][0]["name"], "anchor");
  EXPECT_NEAR(json["props"][0]["length_m"].get<double>(), 6.403, 1e-3);
  EXPECT_GT(made.output_bytes, plan(parse_case(with_block())).output_bytes);
}

} // namespace
} // namespace tremolo::scene::testing
