// Soil test files: what their keys give, and what is refused with which words and where.

#include "scene/soil_test.hpp"
#include "scene/text/errors.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::string_view cyclic = R"(title = "cyclic"
[soil]
library = "pm4sand_dr55"
[test]
kind = "direct_simple_shear"
drainage = "constant_volume"
vertical_stress = 101.3e3
[loading]
kind = "cyclic_stress"
stress_ratio = [0.12, 0.147]
)";

std::string with(std::string_view old, std::string_view replacement) {
  std::string text(cyclic);
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), replacement);
}

SoilTestFile parsed(const std::string& text, SoilTestUse use = SoilTestUse::test) {
  return parse_soil_test(text, "test.toml", ".", use);
}

std::vector<std::string> errors_of(const std::string& text, SoilTestUse use = SoilTestUse::test) {
  std::vector<std::string> messages;
  try {
    parsed(text, use);
  } catch (const CaseErrors& errors) {
    for (const Finding& error : errors.errors())
      messages.push_back(error.message());
  }
  return messages;
}

TEST(SoilTestFile, CyclicTestHasItsValuesAndDefaults) {
  const auto file = parsed(std::string(cyclic));
  EXPECT_EQ(file.title, "cyclic");
  EXPECT_EQ(file.library, "pm4sand_dr55");
  EXPECT_EQ(file.stress_ratios, (std::vector{0.12, 0.147}));
  EXPECT_EQ(file.test.kind, soiltest::Kind::direct_simple_shear);
  EXPECT_EQ(file.test.drainage, soiltest::Drainage::constant_volume);
  EXPECT_EQ(file.test.initial.vertical_stress, 101.3e3);
  EXPECT_EQ(file.test.initial.k0, 0.5);
  EXPECT_EQ(file.test.strain_increment, 1e-5);
  EXPECT_EQ(std::get<soiltest::StressCycles>(file.test.loading).stress_ratio, 0.12);
  EXPECT_EQ(std::get<materials::Pm4Sand>(file.soil.law).h_po, 0.4);
}

TEST(SoilTestFile, OneStressRatioNeedsNoBrackets) {
  EXPECT_EQ(parsed(with("[0.12, 0.147]", "0.147")).stress_ratios, std::vector{0.147});
}

TEST(SoilTestFile, KindsOfLoading) {
  const auto loading = [](const std::string& keys) {
    return parsed(with("kind = \"cyclic_stress\"\nstress_ratio = [0.12, 0.147]\n", keys)).test.loading;
  };
  EXPECT_EQ(std::get<soiltest::Monotonic>(loading("kind = \"monotonic\"\nstrain = 0.2\n")).strain, 0.2);
  const auto cycles = std::get<soiltest::StrainCycles>(
      loading("kind = \"cyclic_strain\"\nstrain_amplitude = [1e-4, 1e-3]\n"));
  EXPECT_EQ(cycles.amplitudes, (std::vector{1e-4, 1e-3}));
  EXPECT_EQ(cycles.cycles, 3);
}

TEST(SoilTestFile, PathIsReadFromItsTable) {
  const tremolo::testing::TemporaryFolder folder;
  folder.write("path.csv", "step,eps_xx,eps_yy,gamma_xy\n0,0,0,0\n10,0,0,1e-4\n");
  const auto text = with("kind = \"cyclic_stress\"\nstress_ratio = [0.12, 0.147]\n",
                         "kind = \"path\"\nfile = \"path.csv\"\n");
  auto path_text = text;
  path_text.replace(path_text.find("direct_simple_shear"), 19, "path");
  path_text.replace(path_text.find("constant_volume"), 15, "drained"); // all strains are prescribed
  const auto file = parse_soil_test(path_text, "test.toml", folder / "", SoilTestUse::test);
  EXPECT_EQ(std::get<soiltest::Path>(file.test.loading).rows.size(), 2U);
  EXPECT_THAT(errors_of(text), ElementsAre(HasSubstr("a path belongs to [test] kind = \"path\""),
                                           HasSubstr("path.csv: there is no such file")));
}

TEST(SoilTestFile, ErrorsOfAPathNameItsTableAndLine) {
  const tremolo::testing::TemporaryFolder folder;
  auto text = with("kind = \"cyclic_stress\"\nstress_ratio = [0.12, 0.147]\n",
                   "kind = \"path\"\nfile = \"path.csv\"\n");
  text.replace(text.find("direct_simple_shear"), 19, "path");
  text.replace(text.find("constant_volume"), 15, "drained");
  const auto refusal = [&](const std::string& table) {
    folder.write("path.csv", table);
    try {
      parse_soil_test(text, "test.toml", folder / "", SoilTestUse::test);
    } catch (const CaseErrors& errors) {
      return errors.errors().at(0).message();
    }
    return std::string();
  };
  EXPECT_THAT(refusal("step,eps_xx,eps_yy,gamma_xy\n0,0,0,0\n10,0,0,x\n"),
              AllOf(HasSubstr("test.toml:10:8: [loading] "), HasSubstr("path.csv: line 3 of the path")));
  EXPECT_THAT(refusal("step,eps_xx,eps_yy,gamma_xy\n0,0,0,0\n-5,0,0,1e-4\n"),
              AllOf(HasSubstr("test.toml:10:8: [loading] "),
                    HasSubstr("path.csv: row 2 of the path (line 3) is -5")));
  EXPECT_THAT(refusal("step,eps_xx,eps_yy,gamma_xy\n0,0,0,0\n"), HasSubstr("path.csv: a path needs"));
}

TEST(SoilTestFile, ErrorsHaveTheirPlaceAndTheNearestKey) {
  EXPECT_THAT(
      errors_of(with("vertical_stress", "vertcal_stress")),
      ElementsAre(HasSubstr("test.toml:4:1: [test] missing 'vertical_stress'"),
                  "test.toml:7:1: [test] unknown key 'vertcal_stress', did you mean 'vertical_stress'?"));
  EXPECT_THAT(
      errors_of(with("\"constant_volume\"", "\"undraind\"")),
      ElementsAre(
          "test.toml:6:12: [test] 'drainage' = \"undraind\" is not known, did you mean 'undrained'?"));
  EXPECT_THAT(
      errors_of(with("0.147]", "-0.1]")),
      ElementsAre("test.toml:10:23: [loading] 'stress_ratio' = -0.1 is out of range, must be in (0, 3]"));
  EXPECT_THAT(errors_of(with("[0.12, 0.147]", "[]")),
              ElementsAre("test.toml:10:16: [loading] 'stress_ratio' is empty"));
  EXPECT_THAT(errors_of(with("[loading]", "[loadin]")),
              ElementsAre(HasSubstr("missing table [loading]"),
                          HasSubstr("unknown key 'loadin', did you mean 'loading'?")));
  EXPECT_THAT(errors_of(with("pm4sand_dr55", "pm4sand_dr56")),
              ElementsAre(HasSubstr(
                  "test.toml:3:11: [soil] 'pm4sand_dr56' is not in the library of soils, did you mean")));
}

TEST(SoilTestFile, ASoilThatCannotBeIsRefusedAtItsKeyOrItsTable) {
  EXPECT_THAT(
      errors_of(with("\"pm4sand_dr55\"", "\"slope_softening\"\ndilation_peak_deg = 50.0")),
      ElementsAre("test.toml:4:21: [soil] 'dilation_peak_deg' = 50 is above 'friction_peak_deg' = 45"));
  EXPECT_THAT(errors_of(with("\"pm4sand_dr55\"", "\"pm4sand_dr55\"\ne_max = 0.4")),
              ElementsAre(HasSubstr("test.toml:2:1: [soil] ")));
}

TEST(SoilTestFile, ATestThatTheLawCannotDoIsRefused) {
  EXPECT_THAT(errors_of(with("direct_simple_shear", "triaxial_compression")),
              ElementsAre(HasSubstr("test.toml:4:1: [test] ")));
}

constexpr std::string_view target = "[target]\ncurve = \"idriss_boulanger\"\n";

TEST(Calibration, TargetOfTheCurveFollowsFromTheDensity) {
  const auto file = parsed(std::string(cyclic) + std::string(target), SoilTestUse::calibration);
  // (N1)60 = 46 x 0.55^2 = 13.9; Idriss & Boulanger (2008): CRR = 0.147.
  EXPECT_NEAR(file.target->stress_ratio, 0.147, 0.001);
  EXPECT_EQ(file.target->cycles, 15.0);
  EXPECT_EQ(file.target->criterion, soiltest::Criterion::strain_3pc);
  EXPECT_EQ(file.target->guess, 0.4);
}

/// Idriss & Boulanger (2008), worked out by hand: C_sigma = 1/(18.9 - 17.3 x 0.55) = 0.106553, so that
/// K_sigma(400 kPa) = 1 - 0.106553 ln(400/101.3) = 0.853663; at 25 kPa it would be 1.149, above 1.1. At D_R =
/// 0.95 C_sigma would be 0.406, above 0.3.
TEST(Calibration, TargetOfTheCurveFallsWithVerticalStress) {
  const auto wanted = [](const std::string& stress) {
    return *parsed(with("101.3e3", stress) + std::string(target), SoilTestUse::calibration).target;
  };
  const double at_one_atmosphere = wanted("101.3e3").stress_ratio;
  EXPECT_NEAR(wanted("400e3").stress_ratio / at_one_atmosphere, 0.853663, 1e-6);
  EXPECT_NEAR(wanted("400e3").curve->overburden_factor, 0.853663, 1e-6);
  EXPECT_NEAR(wanted("25e3").stress_ratio / at_one_atmosphere, 1.1, 1e-12);
  EXPECT_NEAR(overburden_factor(0.95, 202.6e3), 1.0 - 0.3 * std::log(2.0), 1e-12);
  EXPECT_NEAR(overburden_factor(1.15, 202.6e3), 1.0 - 0.3 * std::log(2.0), 1e-12);
}

TEST(Calibration, CurveIsRefusedWhereItDoesNotHold) {
  using enum SoilTestUse;
  EXPECT_THAT(errors_of(with("101.3e3", "101.3e3\nshear_bias = 0.1") + std::string(target), calibration),
              ElementsAre("test.toml:13:9: [target] 'curve' is the strength without static shear; its change "
                          "K_alpha with [test] 'shear_bias' = 0.1 is not given by it: give 'stress_ratio'"));
  const auto of_density = [](const std::string& density) {
    return with("\"pm4sand_dr55\"", "\"pm4sand_dr55\"\nrelative_density = " + density) + std::string(target);
  };
  EXPECT_THAT(errors_of(of_density("1.0"), calibration),
              ElementsAre(HasSubstr("test.toml:13:9: [target] 'curve' at 'relative_density' = 1 is a cyclic "
                                    "stress ratio of 51.8")));
  EXPECT_THAT(errors_of(std::string(cyclic) + "[target]\nstress_ratio = 0.005\n", calibration),
              ElementsAre("test.toml:12:16: [target] 'stress_ratio' = 0.005 is out of range, must be in "
                          "[0.01, 3]"));
}

TEST(Calibration, SaysWhatIsMissingOrCannotBe) {
  using enum SoilTestUse;
  EXPECT_THAT(errors_of(std::string(cyclic), calibration), ElementsAre(HasSubstr("missing table [target]")));
  EXPECT_THAT(errors_of(std::string(cyclic) + "[target]\n", calibration),
              ElementsAre(HasSubstr("missing 'curve' or 'stress_ratio'")));
  EXPECT_THAT(errors_of(std::string(cyclic) + std::string(target) + "stress_ratio = 0.1\n", calibration),
              ElementsAre(HasSubstr("'curve' and 'stress_ratio' exclude each other")));
  EXPECT_THAT(
      errors_of(std::string(cyclic) + std::string(target) + "least = 0.5\n", calibration),
      ElementsAre(HasSubstr("[soil] 'contraction_rate' = 0.4 is the first guess, must be in [0.5, 10]")));
  EXPECT_THAT(errors_of(with("pm4sand_dr55", "pdmy03_dr57") + std::string(target), calibration),
              ElementsAre(HasSubstr("[soil] 'contraction_rate' is a parameter of \"pm4sand\"")));
}

TEST(SoilTestFile, ShippedTestsAreGood) {
  for (const char* folder : {"/cases/soiltests", "/docs/materials/tests"}) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_dir() + folder))
      if (entry.path().extension() == ".toml") {
        const bool fits = entry.path().string().find("calibration") != std::string::npos;
        EXPECT_NO_THROW(load_soil_test(entry.path(), fits ? SoilTestUse::calibration : SoilTestUse::test))
            << entry;
        ++count;
      }
    EXPECT_GE(count, 8) << folder;
  }
}

} // namespace
} // namespace tremolo::scene::testing
