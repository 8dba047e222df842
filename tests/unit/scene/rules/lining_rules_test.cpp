// The rules of linings, each with a case that keeps it and one that breaks it, and the message.

#include "../lining_case.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::string_view ring_circle = "circle = { centre = [10.0, -5.0], radius = 2.1 }";

std::vector<std::string> with_circle(std::string_view circle) {
  return errors_of(ring_with(ring_circle, circle));
}

std::vector<std::string> with_polygon(std::string_view polygon) {
  return errors_of(ring_with(ring_circle, "polygon = " + std::string(polygon)));
}

/// The ring in ground 40 m wide, and more.
std::string in_wide_ground(std::string_view more) {
  std::string text = with("[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]",
                          "[[0.0, -10.0], [40.0, -10.0], [40.0, 0.0], [0.0, 0.0]]", with_ring());
  return with("box = [0.0, -10.0, 20.0, 0.0]", "box = [0.0, -10.0, 40.0, 0.0]", text) + std::string(more);
}

std::string twin(std::string_view name, double x) {
  return "[[lining]]\nname = \"" + std::string(name) + "\"\ncircle = { centre = [" + std::to_string(x) +
         ", -5.0], radius = 2.1 }\nthickness = 0.2\nyoung = 30e9\npoisson = 0.2\ndensity = 2500.0\n"
         "friction = 0.5\n";
}

TEST(Rules, LiningsHaveNames) {
  EXPECT_THAT(errors_of(in_wide_ground(twin("second", 20.0))), IsEmpty());
  EXPECT_THAT(errors_of(in_wide_ground(twin("ring", 20.0))),
              ElementsAre("case.toml:42:8: [[lining]] 'name' = \"ring\" is taken by the lining in line 34"));
}

TEST(Rules, LiningsAreSimple) {
  EXPECT_THAT(with_polygon("[[8.0, -7.0], [12.0, -7.0], [12.0, -3.0], [8.0, -3.0]]"), IsEmpty());
  EXPECT_THAT(
      with_polygon("[[8.0, -7.0], [12.0, -3.0], [12.0, -7.0], [8.0, -3.0]]"),
      ElementsAre("case.toml:35:11: [[lining]] 'polygon' crosses or touches itself: list the corners in "
                  "order around the lining, each once"));
}

TEST(Rules, LiningsLieInGround) {
  EXPECT_THAT(with_circle("circle = { centre = [4.1, -5.0], radius = 2.05 }"), IsEmpty());
  EXPECT_THAT(with_circle("circle = { centre = [3.0, -5.0], radius = 2.1 }"),
              ElementsAre(HasSubstr(
                  "case.toml:35:10: [lining.circle] 'circle' with two cells beside it reaches from x "
                  "= -1.10")));
  EXPECT_THAT(with_circle("circle = { centre = [10.0, -6.5], radius = 2.1 }"),
              ElementsAre(HasSubstr("beyond the sides or the base of the mesh: a larger box holds it")));
  EXPECT_THAT(
      with_circle("circle = { centre = [10.0, -3.0], radius = 2.1 }"),
      ElementsAre(HasSubstr("one cell before 'circle': a lining has soil on all sides; lay it deeper")));
}

TEST(Rules, LiningsAreApart) {
  EXPECT_THAT(errors_of(in_wide_ground(twin("second", 18.3))), IsEmpty());
  EXPECT_THAT(
      errors_of(in_wide_ground(twin("second", 18.1))),
      ElementsAre("case.toml:43:10: [lining.circle] the box around 'circle' comes within four cells, 4 m, of "
                  "that around the lining in line 35: both would meet the same soil"));
  const auto block = [](const char* polygon) {
    return in_wide_ground("[[structure]]\nname = \"block\"\npolygon = " + std::string(polygon) +
                          "\ndensity = 1000.0\nrigid = true\nfriction = 0.5\n");
  };
  EXPECT_THAT(errors_of(block("[[20.0, -2.0], [24.0, -2.0], [24.0, 1.0], [20.0, 1.0]]")), IsEmpty());
  EXPECT_THAT(errors_of(block("[[8.0, -1.0], [12.0, -1.0], [12.0, 1.0], [8.0, 1.0]]")),
              ElementsAre(HasSubstr(
                  "case.toml:35:10: [lining.circle] the box around 'circle' comes within four cells, "
                  "4 m, of that around the structure in line 43")));
}

TEST(Rules, LiningsLieOnFinestLevel) {
  const auto refined = [](const char* box) {
    return errors_of(with_ring() + "[[refine]]\nbox = " + box + "\nlevel = 1\n");
  };
  EXPECT_THAT(refined("[6.0, -9.0, 14.0, -1.0]"), IsEmpty());
  EXPECT_THAT(refined("[8.0, -9.0, 14.0, -1.0]"),
              ElementsAre(HasSubstr(
                  "case.toml:35:10: [lining.circle] 'circle' comes within two cells of cells larger "
                  "than the finest, 0.5 m, on which linings meet soil; add [[refine]] with "
                  "level = 1 and box = [6.8")));
}

TEST(Rules, LiningsAreThin) {
  EXPECT_THAT(errors_of(ring_with("thickness = 0.2", "thickness = 0.05")), IsEmpty());
  EXPECT_THAT(errors_of(ring_with("thickness = 0.2", "thickness = 0.83")), IsEmpty());
  EXPECT_THAT(
      errors_of(ring_with("thickness = 0.2", "thickness = 0.9")),
      ElementsAre("case.toml:36:13: [[lining]] 'thickness' = 0.9 m is too much for a beam around a cavity "
                  "that is 4.2 m wide, must be at most 0.84 m: thicker walls are an elastic [[structure]] "
                  "with a hole"));
  EXPECT_THAT(
      with_circle("circle = { centre = [10.0, -5.0], radius = 1.9 }"),
      ElementsAre(HasSubstr("'circle' is 3.8 m wide at one place, must be at least four cells of 1 m")));
}

TEST(Rules, HingesLieOnLinings) {
  const auto hinges = [](const char* points) {
    return errors_of(ring_with("friction = 0.5", std::string("friction = 0.5\nhinges = ") + points));
  };
  EXPECT_THAT(hinges("[[10.0, -2.9], [10.0, -7.0], [8.1, -5.0]]"), IsEmpty());
  EXPECT_THAT(
      hinges("[[10.0, -3.5]]"),
      ElementsAre("case.toml:41:10: [[lining]] the hinge at [10, -3.5] is 0.601 m from 'circle', must be "
                  "within the lining: at most its thickness, 0.2 m, from its outer face"));
}

TEST(Rules, HingedLiningsHold) {
  const auto hinges = [](const char* points) {
    return remarks_of(ring_with("friction = 0.5", std::string("friction = 0.5\nhinges = ") + points));
  };
  EXPECT_THAT(hinges("[[10.0, -2.9], [12.1, -5.0], [7.9, -5.0]]"), Not(Contains(HasSubstr("mechanism"))));
  EXPECT_THAT(
      hinges("[[10.0, -2.9], [12.1, -5.0], [7.9, -5.0], [10.0, -7.1]]"),
      Contains(HasSubstr("with 4 hinges the lining is a mechanism that only the ground around it holds")));
}

TEST(Rules, LiningsHaveWeight) {
  EXPECT_THAT(errors_of(with_ring()), IsEmpty());
  EXPECT_THAT(errors_of(ring_with("kind = \"gravity\"\n[[stage]]\n", "")),
              ElementsAre(HasSubstr("[[lining]] without weight nothing presses the soil to a lining")));
}

TEST(Linings, StandInGroundWater) {
  std::string wet = with("[soil.sand]",
                         "[water]\nlevel = -1.0\n[soil.sand]\nporosity = 0.4\n"
                         "permeability = 1e-4",
                         with_ring());
  wet = with("density = 1700.0\nyoung = 40e6\npoisson = 0.28\n[[region]]",
             "young = 40e6\npoisson = 0.28\n[[region]]", wet);
  const std::string shaken = "kind = \"gravity\"\n[[stage]]\n";
  const std::string water = "kind = \"water\"\nname = \"pumps\"\nlevel = -2.0\n[[stage]]\n";
  EXPECT_THAT(errors_of(with(shaken, shaken + water, wet)), IsEmpty());
}

TEST(Rules, LiningsLieInGroundBeforeAndAfterAConstruction) {
  const std::string gravity = "kind = \"gravity\"\n[[stage]]\n";
  const auto built = [&](const std::string& corners, const std::string& what) {
    const std::string stage =
        "kind = \"construction\"\nname = \"dig\"\n" + what + " = [\"fill\"]\n[[stage]]\n";
    std::string text = ring_with(gravity, gravity + stage);
    text =
        with("[[region]]\n",
             "[[region]]\nname = \"fill\"\nsoil = \"sand\"\npolygon = " + corners + "\n[[region]]\n", text);
    return with("box = [0.0, -10.0, 20.0, 0.0]", "box = [0.0, -10.0, 20.0, 2.0]", text);
  };
  EXPECT_THAT(errors_of(built("[[8.0, 0.0], [12.0, 0.0], [10.0, 1.0]]", "remove")), IsEmpty());
  EXPECT_THAT(errors_of(with("[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]",
                             "[[0.0, -10.0], [20.0, -10.0], [20.0, -4.0], [0.0, -4.0]]",
                             built("[[0.0, -4.0], [20.0, -4.0], [20.0, 0.0], [0.0, 0.0]]", "place"))),
              Contains(HasSubstr("no [[region]] is at")));
}

TEST(Rules, MonitorsAndLinesLieInNoLining) {
  EXPECT_THAT(
      errors_of(with_ring() + "[[monitor]]\nname = \"m\"\npoint = [10.0, -4.0]\n"),
      ElementsAre("case.toml:43:9: [[monitor]] 'point' [10, -4] lies in lining 'ring', where no soil is"));
  EXPECT_THAT(errors_of(with_ring() + "[[monitor]]\nname = \"m\"\npoint = [10.0, -2.0]\n"), IsEmpty());
  EXPECT_THAT(errors_of(with_ring() +
                        "[[line]]\nname = \"l\"\nfrom = [10.0, -1.0]\nto = [10.0, -9.0]\nspacing = "
                        "0.5\n"),
              ElementsAre(HasSubstr("the line crosses lining 'ring' at [10, -3]")));
}

TEST(Rules, LiningsSlip) {
  EXPECT_THAT(remarks_of(with_ring()), Not(Contains(HasSubstr("tangent"))));
  EXPECT_THAT(
      remarks_of(ring_with("friction = 0.5", "friction = 30.0")),
      Contains(HasSubstr("'friction' = 30 is more than soil has: the tangent of the angle of friction")));
}

} // namespace
} // namespace tremolo::scene::testing
