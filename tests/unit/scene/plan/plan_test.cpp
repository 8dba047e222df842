#include "tests/unit/scene/case_text.hpp"

#include "scene/plan/plan.hpp"
#include "tests/support/paths.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace tremolo::scene::testing {
namespace {

Plan plan_of(const std::string& text) {
  return plan(parse_case(text));
}

std::string slope() {
  auto text = with("[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]",
                   "[[0.0, -10.0], [20.0, -10.0], [20.0, -2.0], [0.0, 0.0]]");
  text = with("right = { model = \"wave\" }", "right = { model = \"wave\", surface = -2.0 }", text);
  return with("form = \"total\"", "form = \"incident\"", text);
}

TEST(Plan, EqualFreeFieldsShareOneProcess) {
  const auto flat = plan_of(std::string(flat_case));
  ASSERT_EQ(flat.sources.size(), 1U);
  EXPECT_EQ(flat.sources[0].name, "left-right-base");
  EXPECT_EQ(program(flat.sources[0].field), "tremolo-wave");
  EXPECT_EQ(flat.sources[0].serves.at(2).field, BaseForm::total);
}

TEST(Plan, DifferentSurfacesNeedTwoAndTheBaseTakesTheIncidentWaveOfOne) {
  const auto sloping = plan_of(slope());
  ASSERT_EQ(sloping.sources.size(), 2U);
  EXPECT_EQ(sloping.sources[0].name, "left-base");
  EXPECT_EQ(sloping.sources[0].surface, 0.0);
  EXPECT_EQ(sloping.sources[1].name, "right");
  EXPECT_EQ(sloping.sources[1].surface, -2.0);
  EXPECT_EQ(source_of(sloping, Side::base).name, "left-base");
  EXPECT_EQ(sloping.sources[0].serves.at(1).field, BaseForm::incident);
  EXPECT_THAT(sloping.base, ::testing::HasSubstr("do not enter"));
}

TEST(Plan, ABlendedBaseTakesTheFieldsOfBothSides) {
  const auto scene = parse_case(with("form = \"incident\"", "form = \"blended\"", slope()));
  const auto sloping = plan(scene);
  ASSERT_EQ(sloping.sources.size(), 2U);
  EXPECT_EQ(sloping.sources[0].name, "left-base");
  EXPECT_EQ(sloping.sources[1].name, "right-base");
  EXPECT_EQ(sloping.sources[1].serves.at(1).field, BaseForm::total);
  EXPECT_EQ(base_sources(scene, sloping).left, "left-base");
  EXPECT_EQ(base_sources(scene, sloping).right, "right-base");
  const auto level = parse_case(with("form = \"total\"", "form = \"blended\""));
  EXPECT_EQ(base_sources(level, plan(level)).right, std::nullopt);
  // Another model at the left: the base's field of that side stands behind that of the right one.
  const auto mixed = parse_case(with("left = { model = \"wave\"", "left = { model = \"fe\"",
                                     with("form = \"incident\"", "form = \"blended\"", slope())));
  EXPECT_EQ(base_sources(mixed, plan(mixed)).left, "base");
  EXPECT_EQ(base_sources(mixed, plan(mixed)).right, "right-base");
}

TEST(Plan, PeriodicSidesNeedNoFreeField) {
  const auto periodic =
      plan_of(with("left = { model = \"wave\" }\nright = { model = \"wave\" }\n", "sides = \"periodic\"\n"));
  ASSERT_EQ(periodic.sources.size(), 1U);
  EXPECT_EQ(periodic.sources[0].name, "base");
  EXPECT_TRUE(std::ranges::find(periodic.effects, "periodic sides", &Effect::name)->on);
  EXPECT_THROW(source_of(periodic, Side::left), std::invalid_argument);
}

TEST(Plan, BaseOfAnotherModelHasItsOwnProcess) {
  const auto mixed = plan_of(with("base = { model = \"wave\"", "base = { model = \"fe\""));
  ASSERT_EQ(mixed.sources.size(), 2U);
  EXPECT_EQ(mixed.sources[1].name, "base");
  EXPECT_EQ(program(mixed.sources[1].field), "tremolo-column");
}

TEST(Plan, CountsParticlesStepsAndFrames) {
  const auto flat = plan_of(std::string(flat_case));
  EXPECT_EQ(flat.particles, 800U); // 20 m x 10 m, four per m2
  // c_p = 173.44 m/s: critical 0.65/173.44 = 3.7477e-3 s, half of it in 2 s: 1067.3 -> 1068 steps.
  EXPECT_NEAR(flat.critical_dt, 3.7477e-3, 1e-7);
  EXPECT_EQ(flat.steps, 1068);
  EXPECT_EQ(flat.frames, 21);
  EXPECT_EQ(plan_of(plus("[time]\ndt = 1e-3\n")).steps, 2000);
}

TEST(Plan, EffectsFollowTheCase) {
  const auto is_on = [](const Plan& plan, std::string_view effect) {
    return std::ranges::find(plan.effects, effect, &Effect::name)->on;
  };
  const auto flat = plan_of(std::string(flat_case));
  for (const auto* off :
       {"gravity", "plasticity", "strain softening", "oblique incidence", "material damping"})
    EXPECT_FALSE(is_on(flat, off)) << off;
  const auto heavy = plan_of(with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]"));
  EXPECT_TRUE(is_on(heavy, "gravity"));
  EXPECT_FALSE(is_on(plan_of(plus("[time]\ntransfer = \"flip\"\n")), "affine velocity"));
  EXPECT_FALSE(is_on(flat, "matched layers"));
  EXPECT_FALSE(is_on(flat, "periodic sides"));
  const auto layered =
      with("base = { model = \"wave\"", "base = { model = \"wave\", absorber = \"matched_layer\"");
  EXPECT_TRUE(is_on(plan_of(layered), "matched layers"));
  EXPECT_EQ(parse_case(layered).boundary.base.absorber, Absorber::matched_layer);
  EXPECT_EQ(parse_case(layered).boundary.left.absorber, Absorber::dashpots);
  EXPECT_EQ(parse_case(layered).mesh.layer_cells, 10);
}

TEST(Plan, ShippedCasesAreGood) {
  for (const auto* name : {"halfspace_box", "slope_oblique"}) {
    const auto scene = load(source_dir() + "/cases/" + name + "/case.toml");
    EXPECT_THAT(explain(scene, plan(scene)), ::testing::HasSubstr(scene.title));
  }
}

} // namespace
} // namespace tremolo::scene::testing
