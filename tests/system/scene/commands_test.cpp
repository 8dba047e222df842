// `tremolo check`, `explain` and `docs` as a user calls them: what they print and how they end.

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

namespace {

using ::testing::HasSubstr;
using tremolo::testing::run_tremolo;

const std::string box = tremolo::source_dir() + "/cases/halfspace_box/case.toml";

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / name;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Commands, CheckAcceptsAShippedCase) {
  const auto [status, output] = run_tremolo("check " + box);
  EXPECT_EQ(status, 0);
  EXPECT_THAT(output, HasSubstr(box + ": ok, 64000 particles"));
}

TEST(Commands, CheckPrintsEveryErrorAndEndsWithTwo) {
  const auto file = scratch("wrong_case.toml");
  std::ofstream(file) << "title = 1\n[mesh]\nsiz = 2.0\n";
  const auto [status, output] = run_tremolo("check " + file.string());
  EXPECT_EQ(status, 2);
  EXPECT_THAT(output, HasSubstr(file.string() + ":1:9: 'title' must be a string, found an integer\n"));
  EXPECT_THAT(output, HasSubstr(file.string() + ":3:1: [mesh] unknown key 'siz', did you mean 'size'?\n"));
  EXPECT_THAT(output, HasSubstr("missing table [motion]"));
  std::filesystem::remove(file);
}

TEST(Commands, MissingFileEndsWithTwo) {
  const auto [status, output] = run_tremolo("check /nowhere/case.toml");
  EXPECT_EQ(status, 2);
  EXPECT_EQ(output, "/nowhere/case.toml:1:1: there is no such file\n");
}

TEST(Commands, WrongCommandLineEndsWithTwo) {
  const auto [status, output] = run_tremolo("chek");
  EXPECT_EQ(status, 2);
  EXPECT_THAT(output, HasSubstr("'chek' is no command, did you mean 'check'?"));
  EXPECT_THAT(run_tremolo("run " + box + " --out /tmp/never --threads 0").output, HasSubstr("in [1, 1024]"));
  EXPECT_EQ(run_tremolo("check").status, 2);
  EXPECT_EQ(run_tremolo("").status, 2);
}

TEST(Commands, WithoutArgumentsTheFiveCommandsOfANewcomerAreShown) {
  const std::string output = run_tremolo("").output;
  for (const char* command :
       {"tremolo new", "tremolo explain", "tremolo run", "tremolo report", "tremolo swap"})
    EXPECT_THAT(output, HasSubstr(command));
}

TEST(Commands, NewWritesCasesThatPassTheCheckAndOverwritesNothing) {
  const auto folder = scratch("new_cases");
  std::filesystem::create_directories(folder);
  for (const char* kind :
       {"slope", "box", "level_ground", "tunnel", "buildings", "levee", "column", "lining"}) {
    const auto made = folder / kind;
    EXPECT_EQ(run_tremolo("new " + made.string() + " --like " + kind).status, 0) << kind;
    EXPECT_EQ(run_tremolo("check " + (made / "case.toml").string()).status, 0) << kind;
    EXPECT_THAT(run_tremolo("new " + made.string()).output,
                HasSubstr("is there already; nothing was written"));
  }
  EXPECT_THAT(run_tremolo("new " + (folder / "x").string() + " --like bridge").output,
              HasSubstr("bridge not in"));
  std::filesystem::remove_all(folder);
}

TEST(Commands, VersionAndHelpEndWithZero) {
  EXPECT_EQ(run_tremolo("--version").status, 0);
  EXPECT_THAT(run_tremolo("--help").output, HasSubstr("explain"));
}

/// A Ricker pulse of 3 Hz, v = V (1 - 2a) exp(-a), a = (w t)^2, under a layer with a quarter of the rock's
/// impedance, in which its echoes do not meet: largest 2 V w sqrt(a) (3 - 2a) exp(-a) at a = (3 - sqrt(6))/2
/// as incident wave, twice that at an outcrop and 4/(1 + 1/4) of it at the surface.
TEST(Commands, CheckAndExplainPrintHowStrongTheMotionIs) {
  const auto file = scratch("strong_case.toml");
  std::ofstream(file) << R"(
title = "layer on rock"
motion = { pulse = { shape = "ricker", frequency = 3.0, time = 0.5, velocity = 0.1 }, wave = "SV", angle_deg = 0.0, reference = [0.0, -30.0] }
surface = { level = 0.0 }
halfspace = { density = 2000.0, vs = 540.0, vp = 1080.0 }
mesh = { size = 1.0, box = [0.0, -30.0, 8.0, 0.0] }
boundary = { left = { model = "wave" }, right = { model = "wave" }, base = { model = "wave" } }
profile = [{ soil = "layer", thickness = 30.0 }]
stage = [{ kind = "shaking", duration_s = 1.0 }]
soil.layer = { model = "linear_elastic", density = 1800.0, vs = 150.0, vp = 300.0 }
region = [{ soil = "layer", polygon = [[0.0, -30.0], [8.0, -30.0], [8.0, 0.0], [0.0, 0.0]] }]
)";
  constexpr double w = 3.0 * std::numbers::pi;
  const double a = 0.5 * (3.0 - std::sqrt(6.0));
  const double peak = 2.0 * 0.1 * w * std::sqrt(a) * (3.0 - 2.0 * a) * std::exp(-a);
  constexpr double near = 0.01; // the largest sample of a series may lie beside the peak
  for (const char* command : {"check ", "explain "}) {
    const std::string output = run_tremolo(command + file.string()).output;
    const auto line = output.find("motion: peak acceleration ");
    ASSERT_NE(line, std::string::npos) << output;
    double incident = 0.0, outcrop = 0.0, surface = 0.0;
    ASSERT_EQ(
        std::sscanf(output.c_str() + line,
                    "motion: peak acceleration %lf m/s2 (%*f g) as incident wave, %lf m/s2 (%*f g) at an "
                    "outcrop, %lf m/s2 (%*f g) at the surface",
                    &incident, &outcrop, &surface),
        3)
        << output.substr(line);
    EXPECT_NEAR(incident, peak, near * peak);
    EXPECT_NEAR(outcrop, 2.0 * peak, near * 2.0 * peak);
    EXPECT_NEAR(surface, 3.2 * peak, near * 3.2 * peak);
  }
  std::filesystem::remove(file);
}

TEST(Commands, ExplainHandsOutTheResolvedCaseAsJson) {
  const auto [status, output] = run_tremolo("explain --json " + box);
  EXPECT_EQ(status, 0);
  for (const char* part : {"\"values\"", "\"served\"", "\"levels_m\"", "\"from_s\"", "\"dt_s\""})
    EXPECT_THAT(output, HasSubstr(part));
}

TEST(Commands, ExplainNamesProcessesAndOffersValues) {
  const auto [status, output] = run_tremolo("explain --values " + box);
  EXPECT_EQ(status, 0);
  EXPECT_THAT(output, HasSubstr("tremolo-wave"));
  EXPECT_THAT(output, HasSubstr("mesh.size = 0.5  # " + box));
  EXPECT_THAT(output, HasSubstr("time.fraction = 0.5  # default"));
}

TEST(Commands, DocsWritesTheReferenceThatIsShippedOrSaysWhyNot) {
  const auto folder = scratch("generated_docs");
  std::filesystem::create_directories(folder);
  EXPECT_EQ(run_tremolo("docs " + folder.string()).status, 0);
  for (const char* page : {"case-file.md", "case.schema.json", "commands.md"})
    EXPECT_EQ(text_of(folder / page), text_of(std::filesystem::path(tremolo::source_dir() + "/docs") / page))
        << page;
  std::filesystem::remove_all(folder);
  const auto [status, output] = run_tremolo("docs /nowhere");
  EXPECT_EQ(status, 2);
  EXPECT_EQ(output, "FOLDER: there is no folder /nowhere\nRun with --help for more information.\n");
}

} // namespace
