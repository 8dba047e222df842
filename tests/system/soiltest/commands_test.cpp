// `tremolo soiltest` and `tremolo calibrate` as a user calls them: what they print, what they write, how they
// end.

#include "scene/soils/soil_library.hpp"
#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using tremolo::testing::run_tremolo;
using tremolo::testing::TemporaryFolder;

const std::string shipped = tremolo::source_dir() + "/cases/soiltests/";

/// A short cyclic test of strong cycles.
const std::string cyclic = R"(title = "strong cycles"
[soil]
library = "pm4sand_dr35"
[test]
kind = "direct_simple_shear"
drainage = "constant_volume"
vertical_stress = 101.3e3
[loading]
kind = "cyclic_stress"
stress_ratio = 0.13
)";

std::string replaced(std::string text, const std::string& old, const std::string& replacement) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), replacement);
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');)
    cells.push_back(cell);
  return cells;
}

/// A column of a table of comma-separated numbers.
std::vector<double> column(const std::filesystem::path& file, const std::string& name) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const auto names = split(line);
  const auto at = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  std::vector<double> values;
  while (at < names.size() && std::getline(stream, line))
    values.push_back(std::stod(split(line).at(at)));
  return values;
}

TEST(SoilTestCommand, PrintsParametersAndCyclesAndWritesTheColumnsOfTheReferences) {
  const TemporaryFolder folder;
  const auto test = folder.write("test.toml", cyclic);
  const auto out = folder / "history.csv";
  const auto [status, output] = run_tremolo("soiltest " + test.string() + " --out " + out.string());
  ASSERT_EQ(status, 0) << output;
  EXPECT_THAT(output, HasSubstr("library pm4sand_dr35"));
  EXPECT_THAT(output, HasSubstr("contraction_rate"));
  EXPECT_THAT(output, HasSubstr("max(0.3, (0.25 + D_R)/2)"));
  EXPECT_THAT(output, HasSubstr("CSR 0.13"));
  std::ifstream stream(out);
  std::string header;
  std::getline(stream, header);
  EXPECT_THAT(header,
              StartsWith("step,cycle,eps_xx,eps_yy,eps_zz,gamma_xy,sig_xx,sig_yy,sig_zz,sig_xy,p,q,"));
  EXPECT_THAT(header, HasSubstr(",z_cum"));
  const auto vertical = column(out, "sig_yy");
  EXPECT_EQ(vertical.front(), -101.3e3); // Pa, tension positive
  const auto shear = column(out, "sig_xy");
  EXPECT_NEAR(*std::ranges::max_element(shear), 0.13 * 101.3e3, 1.0);
  EXPECT_GT(std::ranges::max(column(out, "ru")), 0.9);
}

TEST(SoilTestCommand, AWrittenHistoryIsReplayed) {
  const TemporaryFolder folder;
  const auto test = folder.write("test.toml", cyclic + "largest_strain = 0.002\n");
  const auto first = folder / "first.csv";
  ASSERT_EQ(run_tremolo("soiltest " + test.string() + " --out " + first.string()).status, 0);
  auto path = replaced(cyclic, "direct_simple_shear", "path");
  path = path.substr(0, path.find("kind = \"cyclic_stress\"")) + "kind = \"path\"\nfile = \"first.csv\"\n";
  path = replaced(path, "[loading]", "k0 = 0.5\n[loading]");
  path = replaced(path, "constant_volume", "drained"); // all strains are prescribed
  const auto replay = folder.write("replay.toml", path);
  const auto second = folder / "second.csv";
  const auto [status, output] = run_tremolo("soiltest " + replay.string() + " --out " + second.string());
  ASSERT_EQ(status, 0) << output;
  const auto one = column(first, "sig_xy");
  const auto two = column(second, "sig_xy");
  // Rows are decimated: the increments in between are equal in both, but for the last before a reversal.
  EXPECT_NEAR(one.back(), two.back(), 0.01 * 101.3e3);
}

TEST(SoilTestCommand, MohrCoulombReachesItsPeakAndResidualStrength) {
  const TemporaryFolder folder;
  const auto out = folder / "mc.csv";
  ASSERT_EQ(run_tremolo("soiltest " + shipped + "mohr_coulomb_compression.toml --out " + out.string()).status,
            0);
  const auto vertical = column(out, "sig_yy");
  // sigma_1 = N sigma_3 + 2 c sqrt(N) at 50 kPa: N = 5.8284 and 4 kPa at the peak, N = 2.7698 and 0 at the
  // end.
  EXPECT_NEAR(-*std::ranges::min_element(vertical), 310.74e3, 0.01 * 310.74e3);
  EXPECT_NEAR(-vertical.back(), 138.49e3, 0.01 * 138.49e3);
}

TEST(SoilTestCommand, StrengthCurveAndPicture) {
  const TemporaryFolder folder;
  const auto test = folder.write("test.toml", replaced(cyclic, "0.13", "[0.13, 0.16]"));
  const auto out = folder / "strength.h5";
  const auto [status, output] =
      run_tremolo("soiltest " + test.string() + " --out " + out.string() + " --plot");
  ASSERT_EQ(status, 0) << output;
  EXPECT_GT(std::filesystem::file_size(folder / "strength.png"), 10000U);
  const auto refusal = run_tremolo("soiltest " + test.string() + " --out " + (folder / "x.csv").string());
  EXPECT_EQ(refusal.status, 1);
  EXPECT_THAT(refusal.output, HasSubstr(".csv takes the history of one test, but"));
}

TEST(SoilTestCommand, RefusesWithPlaceAndReason) {
  const TemporaryFolder folder;
  const auto wrong = folder.write("wrong.toml", replaced(cyclic, "drainage", "drainge"));
  const auto key = run_tremolo("soiltest " + wrong.string());
  EXPECT_EQ(key.status, 2);
  EXPECT_THAT(key.output,
              HasSubstr(wrong.string() + ":6:1: [test] unknown key 'drainge', did you mean 'drainage'?"));
  const auto between = folder.write("between.toml", replaced(cyclic, "library = \"pm4sand_dr35\"",
                                                             "model = \"pdmy03\"\nrelative_density = 0.6"));
  const auto density = run_tremolo("soiltest " + between.string());
  EXPECT_EQ(density.status, 2);
  EXPECT_THAT(density.output, HasSubstr(between.string() + ":4:20: [soil] "));
  EXPECT_EQ(run_tremolo("soiltest").status, 2);
  const auto test = folder.write("test.toml", cyclic);
  EXPECT_THAT(run_tremolo("soiltest " + test.string() + " --plot").output,
              HasSubstr("--plot draws from an HDF5 file"));
  EXPECT_THAT(run_tremolo("soiltest " + test.string() + " --out x.txt").output,
              HasSubstr("must end with .h5 or .csv"));
  EXPECT_THAT(run_tremolo("soiltest " + test.string() + " --out /nowhere/x.csv").output,
              HasSubstr("/nowhere/x.csv: there is no folder /nowhere"));
}

TEST(SoilTestCommand, ALoadThatTheSoilCannotCarryEndsTheTestAndSaysSo) {
  const TemporaryFolder folder;
  folder.write("load.csv", "step,eps_xx,eps_yy,sig_xy\n0,0,0,0\n100,0,0,5e5\n"); // Pa, at 100 kPa
  const auto test = folder.write("test.toml", R"(title = "too much"
[soil]
library = "slope_softening"
[test]
kind = "path"
drainage = "drained"
vertical_stress = 100e3
every = 1
[loading]
kind = "path"
file = "load.csv"
by_stress = ["sig_xy"]
)");
  const auto out = folder / "up_to_there.csv";
  const auto [status, output] = run_tremolo("soiltest " + test.string() + " --out " + out.string());
  EXPECT_EQ(status, 1);
  EXPECT_THAT(output, HasSubstr("path ended early: "));
  EXPECT_GT(column(out, "sig_xy").size(), 10U);
}

TEST(SoilTestCommand, AStaticBiasThatTheSoilCannotCarryIsRefusedWhereItStands) {
  const TemporaryFolder folder;
  const auto test = folder.write("bias.toml", replaced(cyclic, "[loading]", "shear_bias = 0.9\n[loading]"));
  const auto [status, output] = run_tremolo("soiltest " + test.string());
  EXPECT_EQ(status, 1);
  EXPECT_THAT(output, HasSubstr(test.string() + ":8:14: [test] shear_bias = 0.9 cannot be applied"));
}

/// Kilopascals for pascals, and a stress at rest that no sand has.
TEST(SoilTestCommand, AndCalibrateTellTheSameNotes) {
  const TemporaryFolder folder;
  const auto head = replaced(replaced(cyclic, "101.3e3", "200.0"), "[loading]", "k0 = 6.0\n[loading]");
  const auto test = folder.write("test.toml", head);
  const auto fit = folder.write("fit.toml", head.substr(0, head.find("[loading]")) +
                                                "[target]\nstress_ratio = 0.13\ncycles = 5\n");
  for (const auto& command : {"soiltest " + test.string(), "calibrate " + fit.string()}) {
    const auto output = run_tremolo(command).output;
    EXPECT_THAT(output, HasSubstr("'vertical_stress' = 200 Pa is that of no specimen")) << command;
    EXPECT_THAT(output, HasSubstr("note: the initial stress mobilises 45.6 degrees of friction")) << command;
  }
}

TEST(SoilTestCommand, ListsTheLibrary) {
  const auto [status, output] = run_tremolo("soiltest --library");
  EXPECT_EQ(status, 0);
  for (const auto& soil : tremolo::scene::soil_library()) {
    EXPECT_THAT(output, HasSubstr(std::string(soil.name)));
    EXPECT_THAT(output, HasSubstr(std::string(soil.title)));
  }
}

TEST(CalibrateCommand, PrintsTheFitAndWritesASoil) {
  const TemporaryFolder folder;
  const auto test = folder.write("test.toml", cyclic.substr(0, cyclic.find("[loading]")) +
                                                  "[target]\nstress_ratio = 0.13\ncycles = 5\n");
  const auto out = folder / "soil.toml";
  const auto [status, output] = run_tremolo("calibrate " + test.string() + " --out " + out.string());
  ASSERT_EQ(status, 0) << output;
  EXPECT_THAT(output, HasSubstr("cyclic stress ratio of 0.13, as given"));
  EXPECT_THAT(output, HasSubstr("Counting: the wanted strain is reached at cycles = N, interpolated within"));
  EXPECT_THAT(output, HasSubstr("Found:  contraction_rate = "));
  EXPECT_THAT(output, HasSubstr("[soil.calibrated]\nlibrary = \"pm4sand_dr35\"\ncontraction_rate = "));
  EXPECT_THAT(output, HasSubstr("updates of the law"));

  // The soil that was written has that strength.
  std::ifstream stream(out);
  std::ostringstream soil;
  soil << stream.rdbuf();
  const auto found = replaced(soil.str(), "[soil.calibrated]", "[soil]");
  const auto again =
      folder.write("again.toml", "title = \"again\"\n" + found + cyclic.substr(cyclic.find("[test]")));
  const auto history = folder / "again.csv";
  ASSERT_EQ(run_tremolo("soiltest " + again.string() + " --out " + history.string()).status, 0);
  const auto cycle = column(history, "cycle");
  const auto strain = column(history, "gamma_xy");
  const auto reached =
      std::ranges::find_if(strain, [](double g) { return std::abs(g) >= 0.03; }) - strain.begin();
  ASSERT_LT(static_cast<std::size_t>(reached), cycle.size());
  EXPECT_NEAR(cycle[static_cast<std::size_t>(reached)], 5.0, 0.5);
}

TEST(CalibrateCommand, HostunSandOfTheLibraryIsWhatItsCalibrationFinds) {
  const auto [status, output] = run_tremolo("calibrate " + shipped + "hostun_calibration.toml");
  ASSERT_EQ(status, 0) << output;
  const std::string found = "Found:  contraction_rate = ";
  ASSERT_THAT(output, HasSubstr(found));
  const auto* soil = tremolo::scene::library_soil("hostun_dr45");
  ASSERT_NE(soil, nullptr);
  const double fitted = std::stod(output.substr(output.find(found) + found.size()));
  EXPECT_NEAR(fitted, (*soil->keys)["contraction_rate"].value_or(0.0), 0.02);
}

TEST(CalibrateCommand, ATargetOutOfReachNamesTheParameterAndItsStrengths) {
  const TemporaryFolder folder;
  const auto text = cyclic.substr(0, cyclic.find("[loading]")) +
                    "[target]\nstress_ratio = 0.5\ncycles = 5\nleast = 0.4\nmost = 0.6\n";
  const auto test = folder.write("test.toml", text);
  const auto [status, output] = run_tremolo("calibrate " + test.string());
  EXPECT_EQ(status, 1);
  EXPECT_THAT(output,
              HasSubstr(test.string() + ":8:1: [target] no 'contraction_rate' from 0.4 to 0.6 gives the "
                                        "cyclic stress ratio 0.5 for strain_3pc in 5 cycles: at 0.4 "
                                        "it is 0.1"));
  const auto drained = folder.write("drained.toml", replaced(replaced(text, "constant_volume", "drained"),
                                                             "= 0.5\ncycles = 5", "= 1.0\ncycles = 1"));
  const auto refusal = run_tremolo("calibrate " + drained.string());
  EXPECT_EQ(refusal.status, 1);
  EXPECT_THAT(refusal.output, HasSubstr("the test is drained, and drained soil does not liquefy"));
}

TEST(CalibrateCommand, SaysWhatItLeavesOutAndChecksItsOutputBeforeTheWork) {
  const TemporaryFolder folder;
  const auto test = folder.write("test.toml", cyclic + "[target]\nstress_ratio = 0.13\ncycles = 5\n");
  EXPECT_THAT(run_tremolo("calibrate " + test.string()).output,
              HasSubstr("note: [loading] is for `tremolo soiltest`"));
  const auto [status, output] = run_tremolo("calibrate " + test.string() + " --out /nowhere/soil.toml");
  EXPECT_EQ(status, 1);
  EXPECT_EQ(output, "tremolo: --out /nowhere/soil.toml: there is no folder /nowhere\n");
}

TEST(CalibrateCommand, RefusesWithoutATarget) {
  const TemporaryFolder folder;
  const auto test = folder.write("test.toml", cyclic);
  const auto [status, output] = run_tremolo("calibrate " + test.string());
  EXPECT_EQ(status, 2);
  EXPECT_THAT(output, HasSubstr("missing table [target]"));
}

} // namespace
