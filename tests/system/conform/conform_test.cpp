// `tremolo conform` passes the template of docs/own-free-field.md, and fails each fault in the row that is
// about it.

#include "tests/support/paths.hpp"

#include <array>
#include <cstdio>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <sys/wait.h>
#include <utility>

namespace tremolo {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

struct Outcome {
  int status = 0;
  std::string text;
};

Outcome conform(const std::string& arguments) {
  const std::string command = fmt::format("{}/tremolo conform {} 2>&1", program_dir(), arguments);
  FILE* pipe = ::popen(command.c_str(), "r");
  Outcome outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t read = std::fread(buffer.data(), 1, buffer.size(), pipe))
    outcome.text.append(buffer.data(), read);
  outcome.status = WEXITSTATUS(::pclose(pipe));
  return outcome;
}

TEST(Conform, TemplatePassesEveryCheck) {
  const auto [status, text] = conform(MY_FIELD);
  EXPECT_EQ(status, 0) << text;
  EXPECT_THAT(text, HasSubstr("14 passed, 0 warned, 0 failed, 0 not reached"));
  // The case's density, found from the values alone, but for central differences over levels 0.5 m apart: (k
  // h)^2/6 is 1 % at 8 Hz.
  const std::string before = "rho = ";
  EXPECT_NEAR(std::stod(text.substr(text.find(before) + before.size())), 1700.0, 17.0);
}

TEST(Conform, TremoloWavePasses) {
  const auto [status, text] = conform(program_dir() + "/tremolo-wave");
  EXPECT_EQ(status, 0) << text;
  EXPECT_THAT(text, HasSubstr("14 passed"));
}

class Fault : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(Fault, FailsInItsRow) {
  const auto& [fault, row] = GetParam();
  const auto [status, text] = conform(fmt::format("{} {}", MISBEHAVING_SOURCE, fault));
  EXPECT_EQ(status, 1) << text;
  EXPECT_THAT(text, ContainsRegex(fmt::format("FAIL  {} ", row)));
  EXPECT_THAT(text, HasSubstr(" 1 failed")) << "nothing else is wrong";
}

INSTANTIATE_TEST_SUITE_P(Faults, Fault,
                         testing::Values(std::pair("kilopascal", "momentum"),
                                         std::pair("nan", "finite values"), std::pair("count", "steps"),
                                         std::pair("order", "steps"), std::pair("greedy", "steps"),
                                         std::pair("slow-clock", "rates"), std::pair("random", "repeats"),
                                         std::pair("late", "quiet start"), std::pair("shallow", "points"),
                                         std::pair("short", "times"), std::pair("role", "handshake"),
                                         std::pair("deaf", "ends after BYE"),
                                         std::pair("stubborn", "ends on ABORT"),
                                         std::pair("orphan", "ends without hub")),
                         [](const auto& fault) {
                           std::string name = fault.param.first;
                           std::erase(name, '-');
                           return name;
                         });

TEST(Conform, SourceWithoutAFaultPasses) {
  const auto [status, text] = conform(MISBEHAVING_SOURCE);
  EXPECT_EQ(status, 0) << text;
}

TEST(Conform, ProgramThatEndsAtOnceShowsItsLastWords) {
  const auto [status, text] =
      conform("--case " + source_dir() + "/cases/halfspace_box/case.toml -- " MY_FIELD " --no-such-option");
  EXPECT_EQ(status, 1);
  EXPECT_THAT(text, ContainsRegex("FAIL  starts and says HELLO .*exited with code 2"));
  EXPECT_THAT(text, HasSubstr("--no-such-option"));
}

TEST(Conform, ProgramThatDoesNotExistIsNamed) {
  const auto [status, text] = conform("/nonexistent/field");
  EXPECT_EQ(status, 1);
  EXPECT_THAT(text, HasSubstr("/nonexistent/field: No such file"));
}

} // namespace
} // namespace tremolo
