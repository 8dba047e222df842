#include "scene/read/override.hpp"

#include "tests/unit/scene/case_text.hpp"
#include "tests/support/paths.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::HasSubstr;

TEST(Override, AngleAloneChangesNothingElse) {
  const auto scene = parse_case(std::string(flat_case));
  EXPECT_EQ(overridden_text(scene, {}), flat_case);
  EXPECT_EQ(overridden_text(scene, {.record = {}, .angle_deg = 15.0, .model = {}}),
            with("angle_deg = 0.0", "angle_deg = 15"));
}

TEST(Override, ModelOfAllSides) {
  const auto scene = parse_case(std::string(flat_case));
  const auto swapped =
      parse_case(overridden_text(scene, {.record = {}, .angle_deg = {}, .model = SourceModel::ode}));
  EXPECT_EQ(swapped.boundary.left.field.model, SourceModel::ode);
  EXPECT_EQ(swapped.boundary.right.field.model, SourceModel::ode);
  EXPECT_EQ(swapped.boundary.base.field.model, SourceModel::ode);
}

TEST(Override, ProgramsOfSidesBecomeAbsolute) {
  auto scene = parse_case(std::string(flat_case));
  scene.text =
      with("left = { model = \"wave\" }", "left = { model = \"external\", program = \"mine/field\" }");
  scene.directory = "/cases";
  EXPECT_THAT(overridden_text(scene, {}), HasSubstr("program = \"/cases/mine/field\""));
}

/// The [boundary] of a case after all models became `wave`; only this part of its text is looked at here.
std::string all_wave(std::string boundary) {
  auto scene = parse_case(std::string(flat_case));
  scene.text = std::move(boundary);
  return overridden_text(scene, {.record = {}, .angle_deg = {}, .model = SourceModel::wave});
}

TEST(Override, FilesAndProgramsOfInlineTablesGoWithTheirModel) {
  EXPECT_EQ(all_wave(R"([boundary]
left = { model = "recording", file = "a, b.h5" } # mine
right = { program = "field" , model = "external", profile = [
  { thickness = 2.0, soil = "sand" },
], surface = 1.0 }
base = { model = "external", form = "total", program = "field" }
)"),
            R"([boundary]
left = { model = "wave" } # mine
right = { model = "wave", profile = [
  { thickness = 2.0, soil = "sand" },
], surface = 1.0 }
base = { model = "wave", form = "total" }
)");
}

TEST(Override, FilesAndProgramsOfTablesGoWithTheirModel) {
  EXPECT_EQ(all_wave(R"([boundary.left]
model = "recording"
  file = "field.h5"
surface = 0.0
[boundary.right]
program = "field" # mine
model = "external"
[boundary]
base.model = "external"
base.form = "total"
base.program = "field")"),
            R"([boundary.left]
model = "wave"
surface = 0.0
[boundary.right]
# mine
model = "wave"
[boundary]
base.model = "wave"
base.form = "total"
)");
}

TEST(Override, FilesAndProgramsUnderDottedKeysGoWithTheirModel) {
  EXPECT_EQ(
      all_wave("boundary = { left.model = \"external\", left.program = \"b\u00f6\", right.program = \"f\", "
               "right.model = \"external\", base = { file = \"x\", model = \"recording\" } }"),
      "boundary = { left.model = \"wave\", right.model = \"wave\", base = { model = \"wave\" } }");
}

/// The [boundary] of a case whose left side and base are replayed.
std::string replayed(std::string boundary) {
  auto scene = parse_case(std::string(flat_case));
  scene.text = std::move(boundary);
  return overridden_text(scene, {.record = {},
                                 .angle_deg = {},
                                 .model = {},
                                 .replays = {{Side::left, {"/r/exchange.h5", Side::left}},
                                             {Side::base, {"/r/exchange.h5", Side::left}}}});
}

TEST(Override, ReplaysTakeTheirSideOfInlineTables) {
  EXPECT_EQ(replayed(R"([boundary]
left = { model = "recording", file = "old.h5", side = "base", surface = 1.0 } # mine
right = { model = "wave" }
base = { form = "total", program = "field", model = "external" }
)"),
            R"([boundary]
left = { model = "recording", file = "/r/exchange.h5", side = "left", surface = 1.0 } # mine
right = { model = "wave" }
base = { form = "total", model = "recording", file = "/r/exchange.h5", side = "left" }
)");
}

TEST(Override, ReplaysTakeTheirSideOfTablesAndDottedKeys) {
  EXPECT_EQ(replayed(R"([boundary.left]
  model = "fe" # mine
surface = 0.0
[boundary]
right.model = "wave"
base.model = "wave"
)"),
            R"([boundary.left]
  model = "recording"
file = "/r/exchange.h5"
side = "left" # mine
surface = 0.0
[boundary]
right.model = "wave"
base.model = "recording"
base.file = "/r/exchange.h5"
base.side = "left"
)");
}

TEST(Override, RecordOfAPulseIsRefused) {
  const auto scene = parse_case(std::string(flat_case));
  EXPECT_THROW(overridden_text(scene, {.record = "x.AT2", .angle_deg = {}, .model = {}}),
               std::invalid_argument);
}

TEST(Override, TextMeansTheSameInAnotherFolder) {
  const auto scene = load(source_dir() + "/cases/slope_oblique/case.toml");
  const auto moved =
      parse(overridden_text(scene, {.record = {}, .angle_deg = 0.0, .model = {}}), "case.toml", "/nowhere");
  EXPECT_EQ(moved.motion.angle_deg, 0.0);
  EXPECT_EQ(std::get<MotionFile>(moved.motion.shakings.front().source).path,
            source_dir() + "/cases/slope_oblique/motion.AT2");
  EXPECT_EQ(moved.regions.size(), scene.regions.size());
}

TEST(Override, RecordIsReplacedInInlineTablesAndBehindUmlauts) {
  const auto text = with(
      "[motion]\npulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }\nwave = \"SV\"\n"
      "angle_deg = 0.0\nreference = [0.0, -10.0]\n",
      "motion = { wave = \"SV\", angle_deg = 0.0, reference = [0.0, -10.0], file = 'b\u00f6schung.AT2' } # "
      "f\u00fcr\n");
  auto scene = parse_case(std::string(flat_case));
  scene.text = text; // the record itself is not needed for the text
  scene.motion.shakings.front().source = MotionFile{"b\u00f6schung.AT2", {}, 1.0};
  EXPECT_THAT(overridden_text(scene, {.record = "/a \"b\".AT2", .angle_deg = 5.0, .model = {}}),
              HasSubstr("motion = { wave = \"SV\", angle_deg = 5, reference = [0.0, -10.0], file = \"/a "
                        "\\\"b\\\".AT2\" } # "
                        "f\u00fcr\n"));
}

} // namespace
} // namespace tremolo::scene::testing
