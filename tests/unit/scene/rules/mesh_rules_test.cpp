// The rules of the mesh and its regions, each with a case that keeps it and one that breaks it, and the
// message.

#include "rule_cases.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Rules, BoxFitsLattice) {
  EXPECT_THAT(errors_of(with("size = 1.0", "size = 0.8\nparticles_per_cell = 4")), IsEmpty());
  EXPECT_THAT(errors_of(with("size = 1.0", "size = 0.75")),
              ElementsAre("case.toml:23:7: [mesh] the width of 'box', 20 m, must be a multiple of the "
                          "cell size, 0.75 m",
                          "case.toml:23:7: [mesh] the height of 'box', 10 m, must be a multiple of the "
                          "particle spacing, 0.375 "
                          "m"));
  // A multiple of the particle spacing is not enough: the sides must lie on nodes.
  EXPECT_THAT(errors_of(with("size = 1.0", "size = 8.0\nparticles_per_cell = 4")),
              ElementsAre("case.toml:24:7: [mesh] the width of 'box', 20 m, must be a multiple of the "
                          "cell size, 8 m"));
  EXPECT_THAT(
      errors_of(with("size = 1.0", "size = 1e-5")),
      ElementsAre(
          "case.toml:22:8: [mesh] 'size' = 1e-05 gives 8e+12 particles in the box, must be at most 1e+09"));
  // Cells far larger than the box: no particle at all.
  EXPECT_THAT(errors_of(with("size = 1.0", "size = 1e8")),
              Contains(HasSubstr("must be a multiple of the cell size")));
  EXPECT_THAT(errors_of(with("box = [0.0, -10.0, 20.0, 0.0]", "box = [0.0, 0.0, 20.0, -10.0]")),
              ::testing::Contains(
                  "case.toml:23:7: [mesh] 'box' is 20 m wide and -10 m high, must be [x_min, y_min, x_max, "
                  "y_max] with both > 0"));
}

TEST(Rules, RegionsAreSimple) {
  const auto bow_tie = with(polygon, "[[0.0, -10.0], [20.0, 0.0], [20.0, -10.0], [0.0, 0.0]]");
  EXPECT_THAT(
      errors_of(bow_tie),
      ::testing::Contains(
          "case.toml:20:11: [[region]] 'polygon' crosses or touches itself: list the corners in order "
          "around the region, each once"));
  const auto line = with(polygon, "[[0.0, -10.0], [20.0, -10.0], [10.0, -10.0]]");
  EXPECT_THAT(errors_of(line), ::testing::Contains(::testing::HasSubstr("crosses or touches itself")));
}

TEST(Rules, RegionsLieInMesh) {
  // A corner on an edge of the mesh lies in it.
  EXPECT_THAT(errors_of(with(polygon, "[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [10.0, 0.0], [0.0, 0.0]]")),
              IsEmpty());
  EXPECT_THAT(errors_of(with(polygon, "[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [10.0, 0.5], [0.0, 0.0]]")),
              ElementsAre("case.toml:20:11: [[region]] corner [10, 0.5] lies outside the mesh, must be in x "
                          "0 to 20 and y -10 "
                          "to 0"));
}

/// A layer of 0.2 m at the surface lies between the places of particles, 0.25 m and 0.75 m below it.
TEST(Rules, RegionsHoldParticles) {
  const auto layered = [](const std::string& level) {
    const auto below = "[[0.0, -10.0], [20.0, -10.0], [20.0, " + level + "], [0.0, " + level + "]]";
    const auto above = "[[0.0, " + level + "], [20.0, " + level + "], [20.0, 0.0], [0.0, 0.0]]";
    return errors_of(with(polygon, below) + "\n[[region]]\nsoil = \"sand\"\npolygon = " + above + "\n");
  };
  EXPECT_THAT(layered("-0.3"), IsEmpty());
  EXPECT_THAT(layered("-0.2"),
              ElementsAre(HasSubstr("[[region]] 'polygon' holds no particle, so its soil would not be "
                                    "there: particles lie in the middle of squares of 0.5 m")));
  EXPECT_THAT(errors_of(plus("[[refine]]\nbox = [0.0, -2.0, 20.0, 0.0]\nlevel = 2\n")), IsEmpty());
}

TEST(Rules, RegionsAreApart) {
  const std::string second = "[[region]]\nsoil = \"sand\"\npolygon = ";
  const auto left = with(polygon, "[[0.0, -10.0], [10.0, -10.0], [10.0, 0.0], [0.0, 0.0]]");
  EXPECT_THAT(errors_of(left + second + "[[10.0, -10.0], [20.0, -10.0], [20.0, 0.0], [10.0, 0.0]]\n"),
              IsEmpty());
  EXPECT_THAT(errors_of(left + second + "[[9.0, -10.0], [20.0, -10.0], [20.0, 0.0], [10.0, 0.0]]\n"),
              ElementsAre("case.toml:33:11: [[region]] 'polygon' overlaps the one in line 20: regions may "
                          "touch but not overlap"));
}

TEST(Rules, MeshResolvesPulse) {
  // c_s = sqrt(E/(2 (1 + nu) rho)) = 95.87 m/s: 15 cells of 1 m up to 6.39 Hz, a pulse of 3 Hz up to 7.5 Hz.
  EXPECT_THAT(
      remarks_of(std::string(flat_case)),
      Contains("case.toml:3:9: warning: [motion.pulse] the pulse reaches up to about 7.5 Hz: the mesh is "
               "coarse for it"));
  EXPECT_THAT(remarks_of(with("frequency = 3.0", "frequency = 2.5")), Not(Contains(HasSubstr("is coarse"))));
}

TEST(Rules, MeshResolvesFrequencies) {
  EXPECT_THAT(remarks_of(std::string(flat_case)),
              Contains(HasSubstr("case.toml:22:8: note: [mesh] shear waves up to 6.39 Hz have 15 cells per "
                                 "wavelength or more")));
  const std::string refined = plus("[[refine]]\nbox = [5.0, -4.0, 15.0, 0.0]\nlevel = 2\n");
  EXPECT_THAT(remarks_of(refined), Contains(HasSubstr("level by level these are, in Hz: 6.39, 12.8, 25.6 on "
                                                      "cells of 1, 0.5, 0.25 m")));
  EXPECT_THAT(remarks_of(std::string(flat_case)), Not(Contains(HasSubstr("level by level"))));
}

TEST(Rules, FacesCarryGravity) {
  const auto one = [](std::string text) {
    return with("size = 1.0\n", "size = 1.0\nparticles_per_cell = 1\n", text);
  };
  const auto heavy = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]");
  EXPECT_THAT(errors_of(heavy), IsEmpty());
  EXPECT_THAT(errors_of(one(std::string(flat_case))), IsEmpty());
  EXPECT_THAT(errors_of(one(heavy)),
              ElementsAre(::testing::HasSubstr(
                  "[mesh] 'particles_per_cell' = 1 with a [[stage]] of kind = \"gravity\"")));
}

} // namespace
} // namespace tremolo::scene::testing
