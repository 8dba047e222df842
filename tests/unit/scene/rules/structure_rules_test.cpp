// The rules of structures, each with a case that keeps it and one that breaks it, and the message.

#include "../structure_case.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// The block with another outline.
std::string outline(std::string_view polygon) {
  return with("[[8.0, 0.0], [12.0, 0.0], [12.0, 4.0], [8.0, 4.0]]", polygon, with_block());
}

std::string second(std::string_view name, std::string_view polygon) {
  return "[[structure]]\nname = \"" + std::string(name) + "\"\npolygon = " + std::string(polygon) +
         "\ndensity = 1000.0\nrigid = true\nfriction = 0.5\n";
}

constexpr std::string_view aside = "[[3.0, 0.0], [6.0, 0.0], [6.0, 4.0], [3.0, 4.0]]";

TEST(Rules, StructuresHaveNames) {
  EXPECT_THAT(errors_of(with_block() + second("wall", aside)), IsEmpty());
  EXPECT_THAT(
      errors_of(with_block() + second("block", aside)),
      ElementsAre("case.toml:40:8: [[structure]] 'name' = \"block\" is taken by the structure in line "
                  "34"));
  EXPECT_THAT(errors_of(with_block() + second("a/b", aside)),
              ElementsAre(HasSubstr("letters, digits, blanks and _ - + . are allowed")));
}

TEST(Rules, StructuresAreSimple) {
  EXPECT_THAT(
      errors_of(outline("[[8.0, 0.0], [12.0, 4.0], [12.0, 0.0], [8.0, 4.0]]")),
      ElementsAre("case.toml:35:11: [[structure]] 'polygon' crosses or touches itself: list the corners "
                  "in order around the structure, each once"));
  const auto hole = [](std::string_view polygon) {
    return errors_of(with_block() + "hole = " + std::string(polygon) + "\n");
  };
  EXPECT_THAT(hole("[[9.0, 1.0], [11.0, 1.0], [11.0, 3.0], [9.0, 3.0]]"), IsEmpty());
  EXPECT_THAT(hole("[[9.0, 1.0], [11.0, 3.0], [11.0, 1.0], [9.0, 3.0]]"),
              ElementsAre(HasSubstr("case.toml:39:8: [[structure]] 'hole' crosses or touches itself")));
  EXPECT_THAT(
      hole("[[9.0, 1.0], [13.0, 1.0], [13.0, 3.0], [9.0, 3.0]]"),
      ElementsAre("case.toml:39:8: [[structure]] 'hole' reaches beyond the outline, 'polygon': the hole "
                  "must lie inside"));
  // Around all of it, and beside it.
  EXPECT_THAT(hole("[[7.0, -1.0], [13.0, -1.0], [13.0, 5.0], [7.0, 5.0]]"),
              ElementsAre(HasSubstr("reaches beyond the outline")));
  EXPECT_THAT(hole("[[14.0, 1.0], [15.0, 1.0], [15.0, 2.0]]"),
              ElementsAre(HasSubstr("reaches beyond the outline")));
}

TEST(Rules, StructuresLieInMesh) {
  EXPECT_THAT(errors_of(outline("[[2.0, -1.0], [6.0, -1.0], [6.0, 40.0], [2.0, 40.0]]")), IsEmpty());
  EXPECT_THAT(errors_of(outline("[[1.5, -1.0], [6.0, -1.0], [6.0, 4.0], [1.5, 4.0]]")),
              ElementsAre("case.toml:35:11: [[structure]] 'polygon' spans x 1.5 to 6 and reaches down to y = "
                          "-1, must lie two cells inside the sides and the base of the mesh: in x 2 to 18, "
                          "above y = -8"));
  EXPECT_THAT(errors_of(outline("[[14.0, -1.0], [18.5, -1.0], [18.5, 4.0], [14.0, 4.0]]")),
              ElementsAre(HasSubstr("must lie two cells inside")));
  EXPECT_THAT(errors_of(outline("[[8.0, -8.5], [12.0, -8.5], [12.0, 4.0], [8.0, 4.0]]")),
              ElementsAre(HasSubstr("must lie two cells inside")));
  // No rule walks along what lies above the mesh.
  EXPECT_THAT(errors_of(outline("[[8.0, 0.0], [12.0, 0.0], [12.0, 1e9], [8.0, 1e9]]")), IsEmpty());
}

TEST(Rules, StructuresAreApart) {
  EXPECT_THAT(
      errors_of(with_block() + second("wall", "[[12.0, 0.0], [15.0, 0.0], [15.0, 4.0], [12.0, 4.0]]")),
      IsEmpty());
  EXPECT_THAT(
      errors_of(with_block() + second("wall", "[[11.0, 0.0], [15.0, 0.0], [15.0, 4.0], [11.0, 4.0]]")),
      ElementsAre("case.toml:41:11: [[structure]] 'polygon' overlaps the structure in line 35: "
                  "structures may touch but not overlap"));
}

TEST(Rules, StructuresAreWide) {
  EXPECT_THAT(errors_of(outline("[[8.0, 0.0], [10.0, 0.0], [10.0, 4.0], [8.0, 4.0]]")), IsEmpty());
  EXPECT_THAT(
      errors_of(outline("[[8.0, 0.0], [9.5, 0.0], [9.5, 4.0], [8.0, 4.0]]")),
      ElementsAre("case.toml:35:11: [[structure]] 'polygon' is 1.5 m thick at one place, must be at "
                  "least two cells of 1 m: soil on one side would meet that on the other; take a thicker "
                  "structure or smaller cells"));
  // The leg of an L, corners in the other sense.
  EXPECT_THAT(
      errors_of(outline("[[8.0, 0.0], [8.0, 1.0], [10.0, 1.0], [10.0, 6.0], [12.5, 6.0], [12.5, 0.0]]")),
      ElementsAre(HasSubstr("is 1 m thick at one place")));
  // Finer cells carry a thinner one.
  EXPECT_THAT(errors_of(outline("[[8.0, 0.0], [9.5, 0.0], [9.5, 4.0], [8.0, 4.0]]") +
                        "[[refine]]\nbox = [4.0, -4.0, 16.0, 0.0]\nlevel = 1\n"),
              IsEmpty());
  EXPECT_THAT(errors_of(heavy() +
                        "[[structure]]\nname = \"pipe\"\ncircle = { centre = [10.0, -5.0], radius = "
                        "1.0 }\ndensity = 1000.0\nrigid = true\nfriction = 0.5\n"),
              IsEmpty());
}

TEST(Rules, RingsAreMeasuredBetweenOutlineAndHole) {
  const auto ring = [](std::string_view hole, std::string_view kind = "young = 1e7\npoisson = 0.2") {
    return errors_of(heavy() +
                     "[[structure]]\nname = \"pipe\"\ncircle = { centre = [10.0, -5.0], radius = 2.5 }\n" +
                     std::string(hole) + "\ndensity = 1000.0\n" + std::string(kind) +
                     "\nfriction = 0.5\n[[refine]]\nbox = [5.0, "
                     "-10.0, 15.0, 0.0]\nlevel = 2\n");
  };
  // Two cells of 0.25 m.
  EXPECT_THAT(ring("hole_circle = { centre = [10.0, -5.0], radius = 2.0 }"), IsEmpty());
  EXPECT_THAT(
      ring("hole_circle = { centre = [10.0, -5.0], radius = 2.1 }"),
      ElementsAre(HasSubstr("'circle' is 0.4 m thick at one place, between it and 'hole_circle', must be "
                            "at least two cells of 0.25 m")));
  // What soil meets of a rigid one is its outline.
  EXPECT_THAT(ring("hole_circle = { centre = [10.0, -5.0], radius = 2.1 }", "rigid = true"), IsEmpty());
  // Thin at the crown alone; a rectangle in the circle at its corners.
  EXPECT_THAT(ring("hole_circle = { centre = [10.0, -4.75], radius = 2.0 }"),
              ElementsAre(HasSubstr("is 0.25 m thick")));
  EXPECT_THAT(ring("hole = [[8.6, -6.4], [11.4, -6.4], [11.4, -3.6], [8.6, -3.6]]"), IsEmpty());
}

TEST(Rules, StructuresLieOnFinestLevel) {
  const auto refined = [](std::string_view box) {
    return errors_of(with_block() + "[[refine]]\nbox = " + std::string(box) + "\nlevel = 1\n");
  };
  EXPECT_THAT(refined("[7.0, -2.0, 13.0, 0.0]"), IsEmpty()); // goes on above the mesh
  EXPECT_THAT(
      refined("[8.0, -2.0, 13.0, 0.0]"),
      ElementsAre("case.toml:35:11: [[structure]] 'polygon' lies within two cells of cells larger than "
                  "the finest, 0.5 m, on which structures meet soil; add [[refine]] with level = 1 and "
                  "box = [7, -1, 13, 5]"));
  EXPECT_THAT(refined("[2.0, -8.0, 5.0, -6.0]"), ElementsAre(HasSubstr("cells larger than the finest")));
  // The inside of a body is nobody's.
  const std::string large = with("[[8.0, 0.0], [12.0, 0.0], [12.0, 4.0], [8.0, 4.0]]",
                                 "[[4.0, -6.0], [16.0, -6.0], [16.0, 1.0], [4.0, 1.0]]", with_block());
  const std::string around = "[[refine]]\nbox = [3.0, -7.0, 17.0, -5.0]\nlevel = 1\n"
                             "[[refine]]\nbox = [3.0, -7.0, 5.0, 0.0]\nlevel = 1\n"
                             "[[refine]]\nbox = [15.0, -7.0, 17.0, 0.0]\nlevel = 1\n";
  EXPECT_THAT(errors_of(large + around + "[[refine]]\nbox = [3.0, -1.0, 17.0, 0.0]\nlevel = 1\n"), IsEmpty());
}

TEST(Rules, StructuresTouchSoil) {
  EXPECT_THAT(errors_of(outline("[[8.0, 0.24], [12.0, 0.24], [12.0, 4.0], [8.0, 4.0]]")), IsEmpty());
  EXPECT_THAT(
      errors_of(outline("[[8.0, 0.26], [12.0, 0.26], [12.0, 4.0], [8.0, 4.0]]")),
      ElementsAre("case.toml:35:11: [[structure]] 'polygon' touches no soil: a structure stands on or in "
                  "a [[region]], or on another one that does"));
  // Two that stand on another, one on the other.
  const std::string roof = second("roof", "[[8.0, 4.0], [12.0, 4.0], [12.0, 8.0], [8.0, 8.0]]");
  const std::string mast = second("mast", "[[9.0, 8.0], [11.0, 8.0], [11.0, 12.0], [9.0, 12.0]]");
  EXPECT_THAT(errors_of(with_block() + mast + roof), IsEmpty());
  EXPECT_THAT(errors_of(with_block() + mast),
              ElementsAre(HasSubstr("case.toml:41:11: [[structure]] 'polygon' touches no soil")));
}

TEST(Rules, StructuresHaveWeight) {
  EXPECT_THAT(errors_of(heavy() + second("block", aside)), IsEmpty());
  EXPECT_THAT(
      errors_of(std::string(flat_case) + second("block", aside)),
      ElementsAre(HasSubstr("case.toml:31:1: [[structure]] without weight nothing presses a structure to "
                            "the soil")));
}

TEST(Rules, StructuresGoWithUsl) {
  EXPECT_THAT(
      errors_of(with_block() + "[time]\ntransfer = \"flip\"\n"),
      ElementsAre(HasSubstr("case.toml:40:12: [time] 'transfer' = \"flip\" does not go with structures: "
                            "contact changes")));
  EXPECT_THAT(errors_of(with_block() + "[time]\norder = \"usl\"\n"), IsEmpty());
}

TEST(Rules, StructuresSlip) {
  const auto friction = [](std::string_view value) {
    return remarks_of(with("friction = 0.5", "friction = " + std::string(value), with_block()));
  };
  EXPECT_THAT(friction("30.0"),
              Contains(HasSubstr("case.toml:38:12: warning: [[structure]] 'friction' = 30 is "
                                 "more than soil has: the tangent of the angle of friction is "
                                 "meant; that of 30 degrees is 0.577")));
  EXPECT_THAT(friction("2.0"), Not(Contains(HasSubstr("tangent"))));
  EXPECT_THAT(friction("0.5\nagainst = [{ soil = \"sand\", friction = 20.0 }]"),
              Contains(HasSubstr("warning: [[structure.against]] 'friction' = 20 is more than soil has")));
}

TEST(Rules, RoundStructuresRoll) {
  const auto pipe = [](std::string_view centre) {
    return remarks_of(heavy() + "[[structure]]\nname = \"pipe\"\ncircle = { centre = " + std::string(centre) +
                      ", radius = 2.0 }\ndensity = 1000.0\nrigid = true\nfriction = 0.5\n");
  };
  EXPECT_THAT(
      pipe("[10.0, 2.0]"),
      Contains(HasSubstr("warning: [structure.circle] 'circle' is round, lies open and has 4 cells across")));
  EXPECT_THAT(pipe("[10.0, -5.0]"), Not(Contains(HasSubstr("is round")))); // soil lies above it
  EXPECT_THAT(remarks_of(with_block()), Not(Contains(HasSubstr("is round"))));
}

TEST(Rules, MonitorsLieInNoStructure) {
  const std::string buried = outline("[[8.0, -2.0], [12.0, -2.0], [12.0, 4.0], [8.0, 4.0]]");
  const auto monitor = [](const char* point) {
    return std::string("[[monitor]]\nname = \"m\"\npoint = ") + point + "\n";
  };
  EXPECT_THAT(
      errors_of(buried + monitor("[10.0, -1.0]")),
      ElementsAre("case.toml:41:9: [[monitor]] 'point' [10, -1] lies in structure 'block', where no soil "
                  "is; with structure = \"block\" the monitor moves with it"));
  // At its foot: the particle of the square beside it.
  EXPECT_THAT(remarks_of(buried + monitor("[12.0, -1.9]")),
              Contains(HasSubstr("follows the particle that starts at [12.25, -1.75], 0.292 m")));
  // A square that is cut has its particle in the middle of what is left, 0.4 m of 0.5 m.
  const std::string cut = outline("[[8.0, -2.0], [12.1, -2.0], [12.1, 4.0], [8.0, 4.0]]");
  EXPECT_THAT(remarks_of(cut + monitor("[12.2, -1.25]")),
              Contains(HasSubstr("follows the particle that starts at [12.3, -1.25], 0.1 m")));
}

TEST(Rules, SidesAreFarFromStructures) {
  constexpr const char* near = "the nearer side is 10 m from the middle of the structures: their settlement "
                               "depends on the box unless that is 4 depths of the model, 40 m";
  EXPECT_THAT(remarks_of(with_block()), Not(Contains(HasSubstr("their settlement"))));
  const auto yielding = with("model = \"linear_elastic\"",
                             "model = \"mohr_coulomb\"\ncohesion_peak = 30e3\ncohesion_residual = 30e3\n"
                             "friction_peak_deg = 0.0\nfriction_residual_deg = 0.0\nsoftening = 0.0",
                             with_block());
  EXPECT_THAT(remarks_of(yielding), Contains(HasSubstr(near)));
}

TEST(Rules, MonitorsLieOnStructures) {
  const auto monitor = [](const char* point, const char* structure) {
    return with_block() + "[[monitor]]\nname = \"m\"\npoint = " + point + "\nstructure = \"" + structure +
           "\"\n";
  };
  EXPECT_THAT(errors_of(monitor("[10.0, 2.0]", "block")), IsEmpty());
  EXPECT_THAT(errors_of(monitor("[12.0, 4.0]", "block")), IsEmpty()); // a corner
  EXPECT_THAT(remarks_of(monitor("[10.0, 2.0]", "block")), Not(Contains(HasSubstr("follows the particle"))));
  EXPECT_THAT(
      errors_of(monitor("[12.1, 2.0]", "block")),
      ElementsAre("case.toml:41:9: [[monitor]] 'point' [12.1, 2] lies outside structure 'block', with "
                  "which the monitor moves"));
  EXPECT_THAT(
      errors_of(monitor("[10.0, 2.0]", "blok")),
      ElementsAre("case.toml:42:13: [[monitor]] structure 'blok' is not defined, did you mean 'block'?"));
  EXPECT_THAT(errors_of(plus("[[monitor]]\nname = \"m\"\npoint = [10.0, -1.0]\nstructure = \"block\"\n")),
              ElementsAre(HasSubstr("structure 'block' is not defined, none is known here")));
}

} // namespace
} // namespace tremolo::scene::testing
