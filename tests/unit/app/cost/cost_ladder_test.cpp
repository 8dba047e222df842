// Ladders of settings: how knobs are written, what cases they make, and what is refused.

#include "app/cost/cost_ladder.hpp"

#include "tests/support/exact_run.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <set>
#include <stdexcept>

namespace {

using namespace tremolo;
using namespace tremolo::app;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

scene::Case given() {
  return scene::parse(tremolo::testing::exact_case, "case.toml", ".");
}

std::vector<std::string> shown(const scene::Axis& axis) {
  std::vector<std::string> all;
  for (const scene::AxisValue& value : axis.values)
    all.push_back(value.shown);
  return all;
}

TEST(Knob, ValuesArePartedByCommasOutsideOfBrackets) {
  const scene::Axis refine = knob_from("mesh.refine=[], [{box=[0,1], level=1}] ,none");
  EXPECT_EQ(refine.key, "mesh.refine");
  EXPECT_THAT(shown(refine), ElementsAre("[]", "[{box=[0,1], level=1}]", "none"));
  EXPECT_EQ(refine.values.back().toml, "");
  EXPECT_THAT(shown(knob_from("a=\"x,y\",z")), ElementsAre("\"x,y\"", "z"));
  EXPECT_EQ(knob_from("a=z").values.front().toml, "\"z\"");
}

TEST(Knob, WhatIsNotWrittenSoIsRefused) {
  for (const char* text : {"mesh.size", "=1", "mesh.size="})
    EXPECT_THAT([&] { knob_from(text); }, ThrowsMessage<std::invalid_argument>(HasSubstr("KEY=VALUE,VALUE")));
  EXPECT_THAT([] { knob_from("a=1,,2"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("a value is empty")));
  EXPECT_THAT([] { knob_from("a=1,2,1"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("the value 1 stands twice")));
}

TEST(Ladder, IsEveryCombination) {
  const auto scene = given();
  const double h = scene.mesh.size;
  const std::vector<scene::Axis> knobs{knob_from("time.transfer=flip,apic"),
                                       knob(size_key, {std::to_string(h), std::to_string(0.5 * h)})};
  const auto rungs = ladder(scene, knobs);
  ASSERT_EQ(rungs.size(), 4U);
  std::set<std::string> folders;
  for (const Variant& rung : rungs) {
    ASSERT_TRUE(rung.scene) << rung.refused;
    folders.insert(rung.name);
  }
  EXPECT_EQ(folders.size(), 4U);
  EXPECT_EQ(rungs[1].scene->time.transfer, scene::Transfer::flip);
  EXPECT_DOUBLE_EQ(rungs[1].scene->mesh.size, 0.5 * h);
  EXPECT_EQ(rungs[2].scene->time.transfer, scene::Transfer::apic);
  EXPECT_DOUBLE_EQ(rungs[2].scene->mesh.size, h);
  EXPECT_EQ(family(knobs, rungs[2].values), "time.transfer = apic");
}

TEST(Ladder, AKnobOfOneValueIsSetButNotNamed) {
  const std::vector<scene::Axis> knobs{knob_from("time.transfer=flip,apic"), knob_from("time.fraction=0.25")};
  const auto rungs = ladder(given(), knobs);
  EXPECT_DOUBLE_EQ(rungs[0].scene->time.fraction, 0.25);
  EXPECT_EQ(family(knobs, rungs[0].values), "time.transfer = flip");
  EXPECT_EQ(setting(knobs, rungs[0].values), "time.transfer = flip, time.fraction = 0.25");
}

TEST(Ladder, AKeyThatNoCaseHasIsRefusedWithTheNearestOne) {
  const auto rungs = ladder(given(), {knob_from("time.fractoin=0.5")});
  EXPECT_FALSE(rungs[0].scene);
  EXPECT_THAT(rungs[0].refused, HasSubstr("did you mean 'fraction'?"));
}

TEST(Ladder, AValueOutOfRangeIsRefusedAndTheOthersStay) {
  const auto rungs = ladder(given(), {knob_from("time.fraction=0.5,1.5")});
  EXPECT_TRUE(rungs[0].scene);
  EXPECT_THAT(rungs[1].refused, HasSubstr("fraction"));
}

TEST(Ladder, AKnobNamedTwiceIsRefused) {
  EXPECT_THAT(
      [] {
        ladder(given(), {knob_from("a.b=1"), knob_from("a.b=2")});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("named twice")));
}

TEST(Ladder, LevelsAndStepsOfTheirOwnAreKnobsToo) {
  const scene::Box box = given().mesh.box;
  const auto scene = scene::parse(fmt::format("{}\n[[refine]]\nbox = [{}, {}, {}, {}]\nlevel = 1\n",
                                              tremolo::testing::exact_case, box.x_min, box.y_min, box.x_max,
                                              0.5 * (box.y_min + box.y_max)),
                                  "case.toml", ".");
  const auto rungs = ladder(scene, {knob_from("refine[0].level=1,2"), knob_from("time.subcycle=false,true")});
  ASSERT_EQ(rungs.size(), 4U);
  for (const Variant& rung : rungs)
    ASSERT_TRUE(rung.scene) << rung.refused;
  EXPECT_EQ(rungs[0].scene->mesh.refine[0].level, 1);
  EXPECT_EQ(rungs[3].scene->mesh.refine[0].level, 2);
  EXPECT_FALSE(rungs[2].scene->time.subcycle);
  EXPECT_TRUE(rungs[3].scene->time.subcycle);
}

TEST(Ladder, WidthMovesTheSidesAndTheSoilWithThem) {
  const auto scene = given();
  const scene::Box& box = scene.mesh.box;
  const double width = 2.0 * box.width();
  const auto rungs = ladder(scene, {knob(width_key, {std::to_string(width)})});
  ASSERT_TRUE(rungs[0].scene) << rungs[0].refused;
  const scene::Box& wide = rungs[0].scene->mesh.box;
  EXPECT_DOUBLE_EQ(wide.width(), width);
  EXPECT_DOUBLE_EQ(wide.x_min + wide.x_max, box.x_min + box.x_max);
  EXPECT_DOUBLE_EQ(wide.y_min, box.y_min);
  for (std::size_t i = 0; i < scene.regions[0].polygon.size(); ++i) {
    const double before = scene.regions[0].polygon[i].x;
    EXPECT_DOUBLE_EQ(rungs[0].scene->regions[0].polygon[i].x, before == box.x_min ? wide.x_min : wide.x_max);
  }
  EXPECT_THAT([&] { ladder(scene, {knob(width_key, {"-3"})}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("a width is a positive number")));
}

TEST(Ladder, FindsTheLargestSizeThatTheCaseTakes) {
  const auto scene = given();
  const std::vector<scene::Axis> knobs{knob(size_key, {std::to_string(scene.mesh.size)})};
  const double wanted = 0.93 * scene.mesh.size;
  const auto size = admissible_size(scene, knobs, {knob_value("?")}, wanted);
  ASSERT_TRUE(size);
  EXPECT_LE(*size, wanted);
  EXPECT_GT(*size, 0.5 * wanted);
  EXPECT_TRUE(rung(scene, knobs, {knob_value(fmt::format("{}", *size))}).scene);
}

TEST(Ladder, TheDefaultOneIsTakenByTheCase) {
  const auto scene = given();
  const auto knobs = default_knobs(scene);
  const auto rungs = ladder(scene, knobs);
  EXPECT_EQ(rungs.size(), 12U);
  EXPECT_TRUE(rungs.back().scene) << rungs.back().refused;
  EXPECT_DOUBLE_EQ(rungs.back().scene->mesh.size, scene.mesh.size);
}

} // namespace
