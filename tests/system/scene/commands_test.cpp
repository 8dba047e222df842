// `tremolo check`, `explain` and `docs` as a user calls them: what they print and how they end.

#include "tests/support/command.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

using ::testing::HasSubstr;
using tremolo::testing::run_tremolo;

const std::string box = TREMOLO_SOURCE_DIR "/cases/halfspace_box/case.toml";

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
  EXPECT_THAT(run_tremolo("run " + box + " --out /tmp/never --threads 0").output, HasSubstr("1 to 1024"));
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
  for (const char* kind : {"slope", "box", "level_ground", "tunnel", "buildings"}) {
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

TEST(Commands, DocsWritesTheReferenceThatIsShippedOrSaysWhyNot) {
  const auto folder = scratch("generated_docs");
  std::filesystem::create_directories(folder);
  EXPECT_EQ(run_tremolo("docs " + folder.string()).status, 0);
  for (const char* page : {"case-file.md", "case.schema.json", "commands.md"})
    EXPECT_EQ(text_of(folder / page), text_of(std::filesystem::path(TREMOLO_SOURCE_DIR "/docs") / page))
        << page;
  std::filesystem::remove_all(folder);
  const auto [status, output] = run_tremolo("docs /nowhere");
  EXPECT_EQ(status, 1);
  EXPECT_EQ(output, "tremolo: cannot write /nowhere/case-file.md: No such file or directory\n");
}

} // namespace
