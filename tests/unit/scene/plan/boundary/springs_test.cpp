// Which sides have springs beside their dashpots, how stiff, around which centre.

#include "scene/plan/boundary/springs.hpp"

#include "../../case_text.hpp"

#include "scene/plan/plan.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

namespace tremolo::scene::testing {
namespace {

constexpr const char* sloping_soil = "[[0.0, -10.0], [20.0, -10.0], [20.0, -2.0], [0.0, 0.0]]";

std::string slope(const std::string& form) {
  auto text = with("[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]", sloping_soil);
  text = with("right = { model = \"wave\" }", "right = { model = \"wave\", surface = -2.0 }", text);
  return with("form = \"total\"", "form = \"" + form + "\"", text);
}

void expect_springs(const std::optional<PlannedSprings>& found, double across, double along, Point centre,
                    bool lags) {
  ASSERT_TRUE(found);
  EXPECT_EQ(found->across, across);
  EXPECT_EQ(found->along, along);
  EXPECT_EQ(found->centre.x, centre.x);
  EXPECT_EQ(found->centre.y, centre.y);
  EXPECT_EQ(found->lags, lags);
}

/// Gives these springs to both sides and the base.
std::string with_springs(const std::string& text, const std::string& a) {
  return with("left = { model = \"wave\"", "left = { model = \"wave\", spring = " + a,
              with("right = { model = \"wave\"", "right = { model = \"wave\", spring = " + a,
                   with("base = { model = \"wave\"", "base = { model = \"wave\", spring = " + a, text)));
}

TEST(Springs, StandBesideDashpotsUnlessTheCaseGivesThemUp) {
  const Case scene = parse_case(std::string(flat_case));
  const Case plain = parse_case(with_springs(std::string(flat_case), "false"));
  for (const Side side : {Side::left, Side::right, Side::base}) {
    EXPECT_FALSE(springs(plain, side));
    expect_springs(springs(scene, side), 1.0, 0.5, {10.0, 0.0}, false);
  }
  EXPECT_EQ(springs_text(plain), "");
  const auto effects = plan(scene).effects;
  const auto effect = std::ranges::find(effects, "springs", &Effect::name);
  EXPECT_TRUE(effect->on);
  EXPECT_THAT(effect->why, ::testing::HasSubstr("base: 1 and 0.5 G/R around (10, 0) m"));
}

TEST(Springs, LagAtTheBaseWhereSurfacesDiffer) {
  for (const char* form : {"blended", "incident"}) {
    const Case scene = parse_case(slope(form));
    expect_springs(springs(scene, Side::left), 0.5, 0.25, {10.0, -1.0}, false);
    expect_springs(springs(scene, Side::base), 0.5, 0.25, {10.0, -1.0}, true);
  }
}

TEST(Springs, FollowTheirKeys) {
  const Case scene = parse_case(
      with("left = { model = \"wave\" }", "left = { model = \"wave\", spring = false }",
           with("form = \"total\"", "form = \"total\", spring = [2.0, 1.0], spring_centre = [4.0, -1.0]")));
  EXPECT_FALSE(springs(scene, Side::left));
  expect_springs(springs(scene, Side::right), 1.0, 0.5, {10.0, 0.0}, false);
  expect_springs(springs(scene, Side::base), 2.0, 1.0, {4.0, -1.0}, false);
}

TEST(Springs, NeedATotalFieldAtTheBase) {
  const auto periodic = [](const std::string& form) {
    return parse_case(with("left = { model = \"wave\" }\nright = { model = \"wave\" }\n",
                           "sides = \"periodic\"\n", with("form = \"total\"", "form = \"" + form + "\"")));
  };
  EXPECT_FALSE(springs(periodic("total"), Side::left));
  EXPECT_TRUE(springs(periodic("total"), Side::base));
  EXPECT_FALSE(springs(periodic("incident"), Side::base));
}

// On the ground's surface below the middle of all structures.
TEST(Springs, LieAroundStructures) {
  auto scene = parse_case(slope("blended"));
  scene.structures.push_back({.name = "hut", .outline = {.corners = {{4.0, -0.4}, {6.0, -0.4}, {6.0, 3.0}}}});
  const Point centre = spring_centre(scene);
  EXPECT_EQ(centre.x, 5.0);
  EXPECT_DOUBLE_EQ(centre.y, -0.5);
}

} // namespace
} // namespace tremolo::scene::testing
