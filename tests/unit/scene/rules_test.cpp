// Each rule with a case that keeps it and one that breaks it, and the message.

#include "case_text.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace tremolo::scene::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::string_view polygon = "[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]";

std::string with_columns(std::string text = std::string(flat_case)) {
  for (const auto* side : {"left = ", "right = ", "base = "})
    text = with(std::string(side) + "{ model = \"wave\"", std::string(side) + "{ model = \"fe\"", text);
  return text;
}

constexpr std::string_view layer = "[[profile]]\nthickness = 4.0\ndensity = 1700.0\nvs = 80.0\nvp = 150.0\n";

TEST(Rules, RecordIsReadable) {
  const auto pulse = "pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }";
  EXPECT_THAT(errors_of(with(pulse, "file = \"absent.AT2\"")),
              ElementsAre("case.toml:3:8: [motion] ./absent.AT2: there is no such file"));

  const auto file = std::filesystem::path(::testing::TempDir()) / "rules_record.AT2";
  std::ofstream(file) << "NPTS= 3, DT= .01 SEC\n0.0 0.1 0.0\n";
  EXPECT_THAT(errors_of(with(pulse, "file = \"" + file.string() + "\"")), IsEmpty());
  std::ofstream(file) << "NPTS= 4, DT= .01 SEC\n0.0 0.1 0.0\n";
  EXPECT_THAT(errors_of(with(pulse, "file = \"" + file.string() + "\"")),
              ElementsAre("case.toml:3:8: [motion] " + file.string() +
                          ":2: the header says NPTS = 4 but there are 3 samples"));
  std::filesystem::remove(file);
}

TEST(Rules, StrengthIsOrdered) {
  const auto soil = [](const char* residual_friction, const char* dilation) {
    return with("model = \"linear_elastic\"",
                std::string("model = \"mohr_coulomb\"\ncohesion_peak = 4e3\n"
                            "cohesion_residual = 0.0\nfriction_peak_deg = 30.0\n"
                            "softening = 15.0\nfriction_residual_deg = ") +
                    residual_friction + "\ndilation_peak_deg = " + dilation);
  };
  EXPECT_THAT(errors_of(soil("28.0", "5.0")), IsEmpty());
  EXPECT_THAT(errors_of(soil("35.0", "5.0")),
              ElementsAre("case.toml:19:25: [soil.sand] 'friction_residual_deg' = 35 is above "
                          "'friction_peak_deg' = 30"));
  EXPECT_THAT(
      errors_of(soil("28.0", "40.0")),
      ElementsAre("case.toml:20:21: [soil.sand] 'dilation_peak_deg' = 40 is above 'friction_peak_deg' = 30"));
  EXPECT_THAT(errors_of(soil("0.0", "0.0")),
              ElementsAre("case.toml:19:25: [soil.sand] 'friction_residual_deg' and "
                          "'cohesion_residual' are both 0: the soil would have no strength"));
}

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
  EXPECT_THAT(errors_of(with(polygon, "[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [10.0, 0.5], [0.0, 0.0]]")),
              ElementsAre("case.toml:20:11: [[region]] corner [10, 0.5] lies outside the mesh, must be in x "
                          "0 to 20 and y -10 "
                          "to 0"));
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

TEST(Rules, PeriodicSidesSuitTheRest) {
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
          "[boundary] sides = \"periodic\"",
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

TEST(Rules, ColumnsAreShakenVertically) {
  EXPECT_THAT(errors_of(with_columns()), IsEmpty());
  EXPECT_THAT(
      errors_of(with("angle_deg = 0.0", "angle_deg = 15.0",
                     with("left = { model = \"wave\" }", "left = { model = \"fe\" }"))),
      ElementsAre(
          "case.toml:25:18: [boundary.left] model = \"fe\" knows vertical incidence only, but [motion] "
          "angle_deg = 15; use model = \"wave\", \"oblique\" or \"eql\", or angle_deg = 0"));
}

TEST(Rules, ObliqueColumnEndsAtTheFirstCriticalAngle) {
  const auto oblique = [](const std::string& angle) {
    return errors_of(with("angle_deg = 0.0", "angle_deg = " + angle,
                          with("left = { model = \"wave\" }", "left = { model = \"oblique\" }")));
  };
  // asin(c_s/c_p) = asin(sqrt(0.22/0.72)) for nu = 0.28
  EXPECT_THAT(oblique("33.5"), IsEmpty());
  EXPECT_THAT(
      oblique("33.6"),
      ElementsAre(
          "case.toml:25:18: [boundary.left] model = \"oblique\" is possible below 33.56 degrees only, "
          "where no P wave of this profile is beyond its critical angle, but [motion] angle_deg = "
          "33.6; use model = \"wave\""));
}

TEST(Rules, AColumnOfTheDomainsCellsTakesVerticalWavesAndWholeParticles) {
  const std::string text = with("left = { model = \"wave\" }", "left = { model = \"mpm\" }");
  EXPECT_THAT(errors_of(text), IsEmpty());
  EXPECT_THAT(errors_of(with("angle_deg = 0.0", "angle_deg = 10.0", text)),
              ElementsAre(::testing::HasSubstr("knows vertical incidence only")));
  EXPECT_THAT(errors_of(with("left = { model = \"wave\" }", "left = { model = \"mpm\", surface = -0.3 }")),
              ::testing::Contains(::testing::HasSubstr("must be a multiple of it")));
}

TEST(Rules, AMotionWithinTheGroundIsThatOfTheTopOfTheHalfSpace) {
  const auto within = [](std::string text) {
    return with("[motion]\n", "[motion]\nkind = \"within\"\n", text);
  };
  const auto to_the_base = with_columns() + with("thickness = 4.0", "thickness = 10.0", std::string(layer));
  EXPECT_THAT(errors_of(within(to_the_base)), IsEmpty());
  EXPECT_THAT(
      errors_of(within(std::string(flat_case) + std::string(layer))),
      ElementsAre(
          "case.toml:7:13: [motion] 'reference' at y = -10 of a motion within the ground must be at the "
          "top of the half-space, y = -4"));
  EXPECT_THAT(errors_of(within(with("left = { model = \"fe\" }", "left = { model = \"eql\" }", to_the_base))),
              ElementsAre(::testing::HasSubstr("takes an incident or outcrop motion")));
}

TEST(Rules, FilesOfModelsExist) {
  EXPECT_THAT(
      errors_of(with("left = { model = \"wave\" }", "left = { model = \"recording\", file = \"none.h5\" }")),
      ElementsAre("case.toml:25:38: [boundary.left] './none.h5': there is no such file"));
  EXPECT_THAT(
      errors_of(with("left = { model = \"wave\" }", "left = { model = \"external\", program = \"/dev\" }")),
      ElementsAre("case.toml:25:40: [boundary.left] '/dev': there is no such file"));
  EXPECT_THAT(errors_of(with("left = { model = \"wave\" }",
                             "left = { model = \"external\", program = \"/etc/passwd\" }")),
              ElementsAre("case.toml:25:40: [boundary.left] '/etc/passwd' is not a program that may be run"));
  EXPECT_THAT(errors_of(with("left = { model = \"wave\" }",
                             "left = { model = \"external\", program = \"/bin/true\" }")),
              IsEmpty());
}

TEST(Rules, DampingSuitsModels) {
  const auto damped = with_columns() + std::string(layer) + "damping = 0.02\n";
  EXPECT_THAT(
      errors_of(damped),
      ElementsAre("case.toml:36:11: [[profile]] 'damping' = 0.02 has no effect without a damping model; set "
                  "[damping] model, e.g. to \"kelvin_voigt\""));
  EXPECT_THAT(errors_of(damped + "[damping]\nmodel = \"rayleigh\"\nfrequencies = [1.0, 5.0]\n"), IsEmpty());
  EXPECT_THAT(errors_of(damped + "[damping]\nmodel = \"hysteretic\"\n"),
              ElementsAre(::testing::HasSubstr(
                  "missing 'reference_hz': at which frequency the Kelvin-Voigt damping of a "
                  "column")));
  EXPECT_THAT(errors_of(damped + "[damping]\nmodel = \"hysteretic\"\nreference_hz = 3.0\n"), IsEmpty());
  const auto waves = std::string(flat_case) + std::string(layer) + "damping = 0.02\n";
  EXPECT_THAT(errors_of(waves + "[damping]\nmodel = \"hysteretic\"\n"), IsEmpty());
  EXPECT_THAT(errors_of(waves + "[damping]\nmodel = \"rayleigh\"\nfrequencies = [1.0, 5.0]\n"),
              ElementsAre(::testing::HasSubstr("model = \"rayleigh\" is for columns")));
}

TEST(Rules, IncidentBaseLiesInHalfspace) {
  const auto deep =
      std::string("[[profile]]\nthickness = 12.0\ndensity = 1600.0\nyoung = 20e6\npoisson = 0.3\n");
  const auto incident = with("reference = [0.0, -10.0]", "reference = [0.0, -12.0]",
                             with("form = \"total\"", "form = \"incident\"", with_columns())) +
                        deep;
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

TEST(Rules, ReferenceLiesInHalfspace) {
  const auto layered = with_columns() + std::string(layer);
  EXPECT_THAT(errors_of(with("reference = [0.0, -10.0]", "reference = [0.0, -3.0]", layered)),
              ElementsAre("case.toml:6:13: [motion] 'reference' at y = -3 lies in the layers, must be in the "
                          "half-space, y <= -4"));
}

TEST(Rules, TimeStepIsStableWithUsl) {
  const auto usl = [](const std::string& step) {
    return errors_of(plus("[time]\norder = \"usl\"\n" + step + "\n"));
  };
  EXPECT_THAT(usl("fraction = 0.85"), IsEmpty());
  EXPECT_THAT(
      usl("fraction = 0.9"),
      ElementsAre("case.toml:33:12: [time] 'fraction' = 0.9 is not stable with order = \"usl\"; allowed: "
                  "at most 0.85"));
  EXPECT_THAT(usl("dt = 3.18e-3"), IsEmpty()); // 0.85 of 3.74777e-3 s
  EXPECT_THAT(
      usl("dt = 3.19e-3"),
      ElementsAre("case.toml:33:6: [time] 'dt' = 0.00319 is not stable with order = \"usl\"; allowed: at "
                  "most 0.85 of the critical step, 0.0031856 s"));
}

TEST(Rules, TimeStepIsStable) {
  // c_p = sqrt(E (1-nu)/((1+nu)(1-2nu) rho)) = 173.44 m/s, h = 1 m: 0.65 h/c_p = 3.74777e-3 s.
  EXPECT_THAT(errors_of(plus("[time]\ndt = 3.74e-3\n")), IsEmpty());
  EXPECT_THAT(errors_of(plus("[time]\ndt = 3.75e-3\n")),
              ElementsAre("case.toml:32:6: [time] 'dt' = 0.00375 exceeds the critical step 0.65 h/c_p = "
                          "0.00374777 s of this mesh "
                          "and its fastest soil"));
}

TEST(Rules, MonitorsLieInSoil) {
  const std::string monitor = "[[monitor]]\nname = \"top\"\npoint = [10.0, 0.0]\n";
  EXPECT_THAT(errors_of(plus(monitor)), IsEmpty());
  EXPECT_THAT(errors_of(plus("[[monitor]]\nname = \"top\"\npoint = [10.0, 0.1]\n")),
              ElementsAre("case.toml:33:9: [[monitor]] 'point' [10, 0.1] lies in no region"));
  EXPECT_THAT(errors_of(plus(monitor + monitor)),
              ElementsAre("case.toml:35:8: [[monitor]] 'name' = \"top\" is taken by the monitor in line 32"));
}

} // namespace
} // namespace tremolo::scene::testing
