// `tremolo verify` as a user calls it, on runs that depart from the exact field by a known amount.

#include "tests/support/command.hpp"
#include "tests/support/exact_run.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace {

using namespace tremolo;
using namespace tremolo::testing;
using ::testing::HasSubstr;

Departure scaled(double factor) {
  return {.factor = [factor](double, double) { return factor; }};
}

nlohmann::json report(const TemporaryFolder& folder) {
  std::ifstream stream(folder / "verify.json");
  return nlohmann::json::parse(stream);
}

TEST(VerifyCommand, PassesWithinTheToleranceAndLeavesAReport) {
  const TemporaryFolder folder;
  write_exact_run(folder / "run.h5", scaled(1.02));
  const auto [status, output] = run_tremolo("verify " + (folder / "").string());
  EXPECT_EQ(status, 0) << output;
  EXPECT_THAT(output, HasSubstr("passed: relative L2 of the whole 2.000 %, tolerance 2.5 %"));
  EXPECT_THAT(output, HasSubstr("largest residual 0.500 % of the largest kinetic energy"));

  const auto json = report(folder);
  EXPECT_EQ(json.at("run"), "run.h5");
  EXPECT_EQ(json.at("wave"), "SV");
  EXPECT_EQ(json.at("base"), "total");
  EXPECT_EQ(json.at("passed"), true);
  EXPECT_EQ(json.at("boundary_width"), 2.5);
  EXPECT_NEAR(json.at("energy_residual").get<double>(), 0.005, 1e-15);
  EXPECT_EQ(json.at("regions").size(), 4);
  EXPECT_EQ(json.at("regions")[0].at("name"), "whole");
  EXPECT_NEAR(json.at("regions")[0].at("relative_l2").get<double>(), 0.02, 1e-7);
  EXPECT_TRUE(std::filesystem::exists(folder / "verify.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "verify.png"));
}

TEST(VerifyCommand, EndsWithOneAboveTheTolerance) {
  const TemporaryFolder folder;
  write_exact_run(folder / "run.h5", scaled(0.97));
  const auto [status, output] = run_tremolo("verify " + (folder / "run.h5").string());
  EXPECT_EQ(status, 1);
  EXPECT_THAT(output, HasSubstr("FAILED: relative L2 of the whole 3.000 %, tolerance 2.5 %"));
  EXPECT_EQ(report(folder).at("passed"), false);
}

TEST(VerifyCommand, EndsWithTwoWhereTheExactFieldIsNotKnown) {
  const TemporaryFolder folder;
  write_exact_run(folder / "run.h5", {}, unequal_surfaces_case());
  const auto [status, output] = run_tremolo("verify " + (folder / "").string());
  EXPECT_EQ(status, 2);
  EXPECT_THAT(output, HasSubstr("cannot be verified: the exact field of this case is not known: the free "
                                "fields have their surfaces at different levels"));
  EXPECT_FALSE(std::filesystem::exists(folder / "verify.json"));
}

TEST(VerifyCommand, NamesARunThatIsNotThere) {
  const auto [status, output] = run_tremolo("verify /nowhere");
  EXPECT_EQ(status, 1);
  EXPECT_THAT(output, HasSubstr("/nowhere"));
}

} // namespace
