// The rules of the sides and the base, each with a case that keeps it and one that breaks it, and the
// message.

#include "rule_cases.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Rules, SoilReachesBoundaries) {
  EXPECT_THAT(
      errors_of(with("right = { model = \"wave\" }", "right = { model = \"wave\", surface = -2.0 }")),
      ::testing::Contains(
          "case.toml:26:37: [boundary.right] soil along the right side, x = 20, reaches from the base to "
          "y = 0 without a gap, but the free field's surface lies at y = -2; both must agree"));
  EXPECT_THAT(
      errors_of(with("[20.0, -10.0]", "[20.0, -9.0]")),
      ::testing::Contains(
          "case.toml:27:8: [boundary.base] soil along the base, y = -10, reaches from the left side to x = "
          "0 without a gap, must reach to the right side, x = 20"));
}

TEST(Rules, TotalBaseHasOneSurface) {
  const std::string sloping =
      with("right = { model = \"wave\" }", "right = { model = \"wave\", surface = -2.0 }",
           with(polygon, "[[0.0, -10.0], [20.0, -10.0], [20.0, -2.0], [0.0, 0.0]]"));
  EXPECT_THAT(
      errors_of(sloping),
      ElementsAre("case.toml:27:33: [boundary.base] form = \"total\" needs one free field, but the surface "
                  "lies at 0 m on "
                  "the left and at -2 m on the right, and no total field has both; use form = \"blended\" or "
                  "\"incident\""));
  EXPECT_THAT(errors_of(with("form = \"total\"", "form = \"incident\"", sloping)), IsEmpty());
  EXPECT_THAT(errors_of(with("form = \"total\"", "form = \"blended\"", sloping)), IsEmpty());
}

TEST(Rules, SidesCanBePeriodic) {
  const auto periodic = [](const std::string& sides, const std::string& text = std::string(flat_case)) {
    return with("left = { model = \"wave\" }\nright = { model = \"wave\" }\n", "sides = \"" + sides + "\"\n",
                text);
  };
  EXPECT_THAT(errors_of(periodic("periodic")), IsEmpty());
  EXPECT_THAT(errors_of(periodic("periodic_springs")), IsEmpty());
  EXPECT_THAT(
      errors_of(periodic("free_field")),
      ElementsAre(
          "case.toml:24:1: [boundary] missing table [boundary.left]: the free field of this side, unless "
          "[boundary] sides = \"periodic\" or \"container\"",
          ::testing::HasSubstr("missing table [boundary.right]")));
  EXPECT_THAT(errors_of(with("left = {", "sides = \"periodic\"\nleft = {")),
              ElementsAre(::testing::HasSubstr("[boundary.left] is the free field of a side, but sides = "
                                               "\"periodic\" have none; remove it"),
                          ::testing::HasSubstr("[boundary.right] is the free field of a side")));
  EXPECT_THAT(errors_of(with("angle_deg = 0.0", "angle_deg = 15.0", periodic("periodic"))),
              ElementsAre(::testing::HasSubstr("[motion] angle_deg = 15 reaches its right side later")));
  const std::string layered =
      with("form = \"total\"", "form = \"total\", absorber = \"matched_layer\"", std::string(flat_case));
  EXPECT_THAT(errors_of(periodic("periodic", layered)), IsEmpty());
  EXPECT_THAT(errors_of(periodic("periodic_springs", layered)),
              ElementsAre(::testing::HasSubstr("would end at sides that springs tie above it")));
  const std::string sloping =
      with(polygon, "[[0.0, -10.0], [20.0, -10.0], [20.0, -2.0], [0.0, 0.0]]", std::string(flat_case));
  EXPECT_THAT(errors_of(periodic("periodic", sloping)),
              ElementsAre(::testing::HasSubstr(
                  "soil along the right side, x = 20, reaches from the base to y = -2")));
}

TEST(Rules, ModelsTakeTheWave) {
  EXPECT_THAT(errors_of(with_columns()), IsEmpty());
  EXPECT_THAT(errors_of(with("angle_deg = 0.0", "angle_deg = 15.0", with_columns())), IsEmpty());
  EXPECT_THAT(
      errors_of(with("angle_deg = 0.0", "angle_deg = 15.0",
                     with("left = { model = \"wave\" }", "left = { model = \"ode\" }"))),
      ElementsAre(
          "case.toml:25:18: [boundary.left] model = \"ode\" knows vertical incidence only, but [motion] "
          "angle_deg = 15; use model = \"wave\", \"fe\" or \"eql\", or angle_deg = 0"));
}

TEST(Rules, ColumnsEndAtTheFirstCriticalAngle) {
  const auto at = [](const std::string& angle) {
    return errors_of(with("angle_deg = 0.0", "angle_deg = " + angle,
                          with("left = { model = \"wave\" }", "left = { model = \"fe\" }")));
  };
  // asin(c_s/c_p) = asin(sqrt(0.22/0.72)) for nu = 0.28
  EXPECT_THAT(at("33.5"), IsEmpty());
  EXPECT_THAT(at("33.6"),
              ElementsAre("case.toml:25:18: [boundary.left] model = \"fe\" is possible below 33.56 degrees "
                          "only, the critical angle of the half-space (P waves of 173.4 m/s), but [motion] "
                          "angle_deg = 33.6; use model = \"wave\" or \"eql\", or angle_deg = 0"));
}

/// A word that cases had before is refused with the one that has taken its place.
TEST(Rules, TheObliqueColumnIsFeNow) {
  EXPECT_THAT(
      errors_of(with("left = { model = \"wave\" }", "left = { model = \"oblique\" }")),
      ElementsAre("case.toml:25:18: [boundary.left] 'model' = \"oblique\" is not known, it is 'fe' now, "
                  "whose column takes waves at an angle"));
  EXPECT_THAT(errors_of(plus("[oblique]\ncell_size = 0.5\n")),
              ElementsAre(::testing::HasSubstr(
                  "unknown key 'oblique', it is 'fe' now, whose column takes waves at an angle")));
}

/// Frictional soil under an oblique wave: what cannot take the angle or the soil sends to `fe`.
TEST(Rules, RefusalsNameModelsThatTakeTheCase) {
  const auto sand =
      with("left = { model = \"wave\" }", "left = { model = \"mpm\" }",
           with("right = { model = \"wave\" }", "right = { model = \"ode\" }",
                plus("[soil.clay]\nmodel = \"drucker_prager\"\ndensity = 1700.0\nvs = 80.0\nvp = "
                     "150.0\ncohesion = 5e3\nfriction_deg = 30.0\n[[profile]]\nthickness = "
                     "10.0\nsoil = \"clay\"\n")));
  const std::string ways = "; use model = \"fe\", or angle_deg = 0";
  EXPECT_THAT(errors_of(with("angle_deg = 0.0", "angle_deg = 10.0", sand)),
              Contains(::testing::EndsWith("but [motion] angle_deg = 10" + ways)));
  EXPECT_THAT(errors_of(sand), ElementsAre(::testing::EndsWith("use model = \"fe\" or \"mpm\"")));
}

TEST(Rules, AColumnOfTheDomainsCellsTakesVerticalWavesAndWholeParticles) {
  const std::string text = with("left = { model = \"wave\" }", "left = { model = \"mpm\" }");
  EXPECT_THAT(errors_of(text), IsEmpty());
  EXPECT_THAT(errors_of(with("angle_deg = 0.0", "angle_deg = 10.0", text)),
              ElementsAre(::testing::HasSubstr("knows vertical incidence only")));
  EXPECT_THAT(errors_of(with("left = { model = \"wave\" }", "left = { model = \"mpm\", surface = -0.3 }")),
              ::testing::Contains(::testing::HasSubstr("must be a multiple of it")));
}

TEST(Rules, ModelFilesExist) {
  EXPECT_THAT(
      errors_of(with("left = { model = \"wave\" }", "left = { model = \"recording\", file = \"none.h5\" }")),
      ElementsAre("case.toml:25:38: [boundary.left] './none.h5': there is no such file"));
  EXPECT_THAT(
      errors_of(with("left = { model = \"wave\" }", "left = { model = \"external\", program = \"/dev\" }")),
      ElementsAre(
          "case.toml:25:40: [boundary.left] '/dev': cannot be read: this is a folder; give the file in it"));
  EXPECT_THAT(errors_of(with("left = { model = \"wave\" }",
                             "left = { model = \"external\", program = \"/etc/passwd\" }")),
              ElementsAre("case.toml:25:40: [boundary.left] '/etc/passwd' is not a program that may be run"));
  EXPECT_THAT(errors_of(with("left = { model = \"wave\" }",
                             "left = { model = \"external\", program = \"/bin/true\" }")),
              IsEmpty());
}

TEST(Rules, IncidentBaseLiesInHalfspace) {
  const auto deep =
      std::string("[[profile]]\nthickness = 12.0\ndensity = 1600.0\nyoung = 20e6\npoisson = 0.3\n");
  const auto incident = with("reference = [0.0, -10.0]", "reference = [0.0, -12.0]",
                             with("form = \"total\"", "form = \"incident\"", with_columns())) +
                        deep;
  EXPECT_THAT(errors_of(with("form = \"incident\"", "form = \"total\"", incident)), IsEmpty());
  EXPECT_THAT(errors_of(with("thickness = 12.0", "thickness = 10.0", incident)), IsEmpty());
  EXPECT_THAT(errors_of(with("[motion]\n", "[motion]\nkind = \"within\"\n", incident)),
              Contains(HasSubstr("form = \"incident\" needs an incident or outcrop motion")));
  EXPECT_THAT(
      errors_of(incident),
      ElementsAre("case.toml:27:31: [boundary.base] form = \"incident\" needs a base in the half-space, y <= "
                  "-12, but [mesh] box ends at y = -10 within the layers; use form = \"total\" or a deeper "
                  "box"));
}

TEST(Rules, LayersOfOneSideNeedAnIncidentBase) {
  const auto own = [](const std::string& soil, const std::string& text) {
    return with("left = { model = \"wave\" }",
                "left = { model = \"wave\", profile = [{ thickness = 4.0, soil = \"" + soil + "\" }] }",
                text);
  };
  const auto incident = with("form = \"total\"", "form = \"incident\"");
  EXPECT_THAT(errors_of(own("sand", incident)), IsEmpty());
  EXPECT_THAT(errors_of(own("sand", std::string(flat_case))),
              ElementsAre(::testing::HasSubstr("but a side has layers of its own")));
  EXPECT_THAT(errors_of(own("snad", incident)),
              ElementsAre(::testing::HasSubstr("soil 'snad' is not defined, did you mean 'sand'")));
}

TEST(Rules, IncidentBaseHasDashpots) {
  const auto layered = with("form = \"total\"", "form = \"incident\", absorber = \"matched_layer\"");
  EXPECT_THAT(remarks_of(layered), Contains(HasSubstr("warning: [boundary.base] the base takes the incident "
                                                      "wave alone")));
  EXPECT_THAT(remarks_of(with("\"incident\"", "\"blended\"", layered)),
              Not(Contains(HasSubstr("takes the incident wave alone"))));
}

TEST(Rules, SpringsSuitBoundary) {
  const auto left = [](const std::string& keys) {
    return with("left = { model = \"wave\" }", "left = { model = \"wave\", " + keys + " }");
  };
  EXPECT_THAT(errors_of(left("spring = [2.0, 1.0], spring_centre = [10.0, 0.0]")), IsEmpty());
  EXPECT_THAT(errors_of(left("spring = false")), IsEmpty());
  EXPECT_THAT(errors_of(left("absorber = \"matched_layer\", spring = [2.0, 1.0]")),
              ElementsAre(HasSubstr("[boundary.left] 'spring' does not apply to absorber = "
                                    "\"matched_layer\", only to dashpots")));
  EXPECT_THAT(errors_of(left("spring = true")),
              ElementsAre(HasSubstr("[boundary.left] 'spring' must be an array of 2 numbers [a_n, a_t] or "
                                    "false, found a boolean")));
  EXPECT_THAT(errors_of(left("spring = [1.0, -0.5]")),
              ElementsAre(HasSubstr("[boundary.left] 'spring' = -0.5 is out of range, must be >= 0")));
  EXPECT_THAT(errors_of(left("spring_centre = [10.0, 0.0]")), IsEmpty());
  EXPECT_THAT(
      errors_of(left("spring = false, spring_centre = [10.0, 0.0]")),
      ElementsAre(HasSubstr("[boundary.left] spring_centre is the centre of springs, and spring = false "
                            "has none")));
}

TEST(Rules, SpringsHaveTheirField) {
  const auto says = [](const std::string& text, const char* what) {
    EXPECT_THAT(remarks_of(text), Contains(HasSubstr(what)));
  };
  const auto heavy = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]",
                          with("form = \"total\"", "form = \"incident\""));
  const auto periodic =
      with("left = { model = \"wave\" }\nright = { model = \"wave\" }\n", "sides = \"periodic\"\n", heavy);
  says(periodic,
       "warning: [boundary.base] form = \"incident\" with sides = \"periodic\" has no total free field "
       "that springs of the base could move against");
  EXPECT_THAT(remarks_of(with("\"incident\"", "\"incident\", spring = false", periodic)),
              Not(Contains(HasSubstr("springs"))));
  says(with("form = \"total\"", "form = \"total\", spring = [1.0, 0.5], spring_centre = [10.0, -30.0]"),
       "warning: [boundary.base] [10, -30] lies outside [mesh] box");
  const std::string sloping =
      with("right = { model = \"wave\" }", "right = { model = \"wave\", surface = -2.0 }",
           with(polygon, "[[0.0, -10.0], [20.0, -10.0], [20.0, -2.0], [0.0, 0.0]]"));
  EXPECT_THAT(remarks_of(with("form = \"total\"", "form = \"blended\"", sloping)),
              Not(Contains(HasSubstr("spring"))));
  says(with("form = \"total\"", "form = \"blended\", spring = [2.0, 1.0]", sloping),
       "warning: [boundary.base] spring = [2, 1] under sides that differ");
}

TEST(Rules, RecordingsAreFilesOfHdf5) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "junk.h5";
  std::ofstream(file) << "this is no recording";
  EXPECT_THAT(errors_of(with("left = { model = \"wave\" }",
                             "left = { model = \"recording\", file = \"" + file.string() + "\" }")),
              ElementsAre(HasSubstr("is no recording: not a file of HDF5")));
  std::filesystem::remove(file);
}

TEST(Rules, AnOutcropBeyondTheCriticalAngleHasNoFactor) {
  // nu = 0.28: sin(angle) = c_s/c_p at 33.57 degrees.
  const auto at = [](const char* angle, const char* kind) {
    return errors_of(
        with("angle_deg = 0.0", std::string("angle_deg = ") + angle + "\nkind = \"" + kind + "\""));
  };
  EXPECT_THAT(at("33.0", "outcrop"), IsEmpty());
  EXPECT_THAT(at("45.0", "incident"), IsEmpty());
  EXPECT_THAT(
      at("45.0", "outcrop"),
      ElementsAre(HasSubstr("[motion] kind = \"outcrop\" at 45 degrees, beyond the critical angle of 33.")));
}

constexpr std::string_view shaken_case = R"(title = "A box on a table"
[motion]
kind = "within"
wave = "SV"
pulse = { shape = "ricker", frequency = 4.0, time = 0.4, velocity = 0.1 }
[mesh]
size = 1.0
box = [0.0, -4.0, 8.0, 0.0]
[soil.sand]
model = "linear_elastic"
density = 1700.0
young = 40e6
poisson = 0.28
[[region]]
soil = "sand"
polygon = [[0.0, -4.0], [8.0, -4.0], [8.0, -1.0], [0.0, 0.0]]
[boundary]
sides = "container"
base = { model = "shaking_table" }
[[stage]]
kind = "shaking"
duration_s = 1.0
)";

TEST(Rules, ShakingTableSuitsCase) {
  const auto changed = [](std::string_view from, std::string_view to) {
    return errors_of(with(std::string(from), std::string(to), std::string(shaken_case)));
  };
  EXPECT_THAT(errors_of(std::string(shaken_case)), IsEmpty());
  EXPECT_THAT(
      changed("kind = \"within\"\n", ""),
      ElementsAre("case.toml:2:1: [motion] kind = \"incident\" is that of a wave in rock, but a shaking "
                  "table moves as prescribed: its motion is kind = \"within\""));
  EXPECT_THAT(
      changed("wave = \"SV\"", "wave = \"SV\"\nangle_deg = 15.0"),
      ElementsAre(HasSubstr("case.toml:5:13: [motion] angle_deg = 15, but a shaking table moves along x")));
  EXPECT_THAT(
      changed("sides = \"container\"", "sides = \"periodic_springs\""),
      ElementsAre(HasSubstr("case.toml:18:9: [boundary] 'sides' = \"periodic_springs\" does not go with a "
                            "shaking table: it carries a container")));
  EXPECT_THAT(
      changed("[mesh]\n", "[surface]\nlevel = 0.0\n[mesh]\n"),
      ElementsAre("case.toml:6:1: [surface] [surface] is ground of a free field, which a shaking table does "
                  "not stand on; remove it"));
  EXPECT_THAT(changed("base = { model = \"shaking_table\" }",
                      "base = { model = \"shaking_table\", form = \"total\" }"),
              ElementsAre(HasSubstr("'form' does not apply to model = \"shaking_table\"")));
  EXPECT_THAT(
      changed("poisson = 0.28", "poisson = 0.28\nporosity = 0.4\npermeability = 1e-4\n[water]\nlevel = -2.0"),
      ::testing::Each(Not(HasSubstr("shaking table"))));
  EXPECT_THAT(
      errors_of(
          with("left = { model = \"wave\" }\nright = { model = \"wave\" }\n", "sides = \"container\"\n")),
      ElementsAre(HasSubstr("'sides' = \"container\" does not go with a base on ground: its walls stand on "
                            "a shaking table")));
}

} // namespace
} // namespace tremolo::scene::testing
