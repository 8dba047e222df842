// `tremolo check`, `explain` and `docs` as a user calls them: what they print and how they end.

#include "tests/support/command.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace {

using ::testing::HasSubstr;
using tremolo::testing::run_tremolo;

const std::string box = TREMOLO_SOURCE_DIR "/cases/halfspace_box/case.toml";

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / name;
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
  EXPECT_THAT(run_tremolo("run " + box + " --out /tmp/never --threads 0").output, HasSubstr("1 to 1024"));
  EXPECT_EQ(run_tremolo("check").status, 2);
  EXPECT_EQ(run_tremolo("").status, 2);
}

TEST(Commands, VersionAndHelpEndWithZero) {
  EXPECT_EQ(run_tremolo("--version").status, 0);
  EXPECT_THAT(run_tremolo("--help").output, HasSubstr("explain"));
}

TEST(Commands, CheckAndExplainPrintHowStrongTheMotionIs) {
  for (const char* command : {"check ", "explain "})
    EXPECT_THAT(run_tremolo(command + box).output, HasSubstr("motion: peak acceleration ")) << command;
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

TEST(Commands, DocsWritesBothFilesOrSaysWhyNot) {
  const auto folder = scratch("generated_docs");
  std::filesystem::create_directories(folder);
  EXPECT_EQ(run_tremolo("docs " + folder.string()).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "case-file.md"));
  EXPECT_TRUE(std::filesystem::exists(folder / "case.schema.json"));
  std::filesystem::remove_all(folder);
  const auto [status, output] = run_tremolo("docs /nowhere");
  EXPECT_EQ(status, 1);
  EXPECT_EQ(output, "tremolo: cannot write /nowhere/case-file.md: No such file or directory\n");
}

} // namespace
