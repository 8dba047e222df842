// What a soil test refuses before it starts or on the way, and what it says about its results.

#include "materials/plastic/mohr_coulomb.hpp"
#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/sand/pm4sand/pm4sand.hpp"
#include "materials/soiltest/notes.hpp"
#include "materials/soiltest/path/path_table.hpp"
#include "materials/soiltest/size.hpp"
#include "materials/soiltest/soil_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;
using Refusal = std::invalid_argument;

const materials::Elasticity elastic = {1700.0, 40e6, 0.28};
const materials::Law elastic_law = materials::LinearElastic{elastic};

SoilTest simple_shear(Loading loading) {
  SoilTest test;
  test.initial = {100e3, 0.5};
  test.loading = std::move(loading);
  return test;
}

/// PDMY03 after a reversal misses 0.5 % of the vertical stress with these increments: more than what is said,
/// less than what ends a test.
TEST(SoilTestLimits, AMissedStressIsReported) {
  SoilTest test = simple_shear(StrainCycles{{0.01}, 2});
  test.drainage = Drainage::drained;
  test.initial.vertical_stress = 101e3;
  test.strain_increment = 1e-5;
  const Result result = run(materials::pdmy03(materials::pdmy03_recommended(0.33)), test);
  EXPECT_EQ(result.end, End::completed);
  double missed = 0.0;
  for (const double vertical : result.history.column("sig_yy")) {
    missed = std::max(missed, std::abs(vertical + 101e3));
  }
  EXPECT_GT(missed, 1e-4 * 101e3);
  EXPECT_NEAR(result.largest_missing_stress / missed, 1.0, 1e-3);
}

TEST(SoilTestLimits, ATestWithoutEndIsRefusedWithItsSize) {
  SoilTest test = simple_shear(StrainCycles{{0.2}, 1000});
  test.strain_increment = 1e-8;
  EXPECT_THAT([&] { validate(elastic_law, test); },
              ThrowsMessage<Refusal>(AllOf(HasSubstr("8e+10 increments"), HasSubstr("strain_increment"))));
  test = simple_shear(StressCycles{0.1, 0.06, 1e5});
  EXPECT_THAT([&] { validate(elastic_law, test); }, ThrowsMessage<Refusal>(HasSubstr("most_cycles")));
  test = simple_shear(Monotonic{1.0});
  test.strain_increment = 2e-8;
  EXPECT_THAT([&] { validate(elastic_law, test); },
              ThrowsMessage<Refusal>(HasSubstr("every = 1 must be at least 5")));
  test.every = 5;
  EXPECT_NO_THROW(validate(elastic_law, test));
}

/// The estimate of strain cycles is what they take.
TEST(SoilTestLimits, IncrementsAreCountedBeforehand) {
  const SoilTest test = simple_shear(StrainCycles{{1e-3, 2e-3}, 3});
  EXPECT_NEAR(increments(test), static_cast<double>(run(elastic_law, test).increments), 0.5);
  EXPECT_EQ(increments(test), 3e-3 * 14.0 / 1e-5);
}

SoilTest along(const std::string& table, const std::vector<std::string>& by_stress, double unit) {
  std::istringstream stream(table);
  SoilTest test = simple_shear(read_path(stream, by_stress, unit));
  test.kind = Kind::path;
  test.drainage = Drainage::drained;
  return test;
}

TEST(SoilTestPath, StartsFromTheStressOfItsFirstRow) {
  const std::string kilopascal = "eps_xx,eps_yy,gamma_xy,sig_xx,sig_yy\n0,0,0,-50,-100\n0,0,1e-4,-50,-100\n";
  const auto refused = [](const SoilTest& test, const std::string& words) {
    EXPECT_THAT([&] { validate(elastic_law, test); },
                ThrowsMessage<Refusal>(AllOf(HasSubstr("line 2"), HasSubstr(words))));
  };
  EXPECT_NO_THROW(validate(elastic_law, along(kilopascal, {"sig_yy"}, 1e3)));
  EXPECT_NO_THROW(validate(elastic_law, along(kilopascal, {}, 1e3)));
  refused(along(kilopascal, {"sig_yy"}, 1.0), "kPa for Pa?");
  refused(along(kilopascal, {}, 1.0), "kPa for Pa?"); // a replay, which follows its strains alone
  refused(along(kilopascal, {}, 1e6), "Pa for kPa?");
  SoilTest other = along(kilopascal, {"sig_yy"}, 1e3);
  other.initial.vertical_stress = 120e3;
  refused(other, "sig_yy = -100000 Pa, but the test starts from -120000 Pa");
}

/// sigma_xx = -50, sigma_yy = -100 kPa at phi = 30 deg: |tau| <= sqrt((75 sin 30 deg)^2 - 25^2) = 27.95 kPa.
TEST(SoilTestPath, AStressBeyondTheStrengthEndsTheTestThere) {
  materials::MohrCoulomb sand;
  sand.elastic = elastic;
  sand.friction_peak = sand.friction_residual = std::numbers::pi / 6.0;
  const std::string table = "step,eps_xx,eps_yy,gamma_xy,sig_xx,sig_yy,sig_xy\n0,0,0,0,-50,-100,0\n"
                            "100,0,0,0,-50,-100,50\n";
  const Result result = run(sand, along(table, {"sig_xx", "sig_yy", "sig_xy"}, 1e3));
  EXPECT_EQ(result.end, End::refused);
  EXPECT_THAT(result.end_reason, HasSubstr("no strain gives the prescribed stress"));
  // In increments of 0.5 kPa.
  const double reached = result.history.column("sig_xy").back();
  EXPECT_GT(reached, 27.4e3);
  EXPECT_LT(reached, 27.96e3);
}

TEST(SoilTestPath, ColumnsNamedTwiceAndStepsThatFallAreRefusedWithTheirLine) {
  std::istringstream twice("eps_xx,eps_yy,gamma_xy,eps_yy\n0,0,0,0\n");
  EXPECT_THAT([&] { read_path(twice); },
              ThrowsMessage<Refusal>(AllOf(HasSubstr("line 1"), HasSubstr("\"eps_yy\" twice"))));
  const SoilTest back = along("step,eps_xx,eps_yy,gamma_xy\n\n5,0,0,0\n4,0,0,1e-4\n", {}, 1.0);
  EXPECT_THAT([&] { validate(elastic_law, back); },
              ThrowsMessage<Refusal>(HasSubstr("row 2 of the path (line 4)")));
}

TEST(SoilTestNotes, SayThatTheLawCannotHoldTheInitialStress) {
  SoilTest test = simple_shear(Monotonic{});
  const materials::Law multi_yield = materials::pdmy03(materials::pdmy03_recommended(0.57));
  materials::Pm4SandInput input;
  input.density = 1900.0;
  input.relative_density = 0.55;
  input.G_o = 677.0;
  input.h_po = 0.40;
  const materials::Law sand = materials::pm4sand(input);
  EXPECT_THAT(notes(multi_yield, test), IsEmpty());
  EXPECT_THAT(notes(sand, test), IsEmpty());
  test.initial.k0 = 0.05; // outside of the failure surfaces of both
  EXPECT_THAT(notes(multi_yield, test), Contains(AllOf(HasSubstr("cannot hold the initial stress"),
                                                       HasSubstr("sig_yy = -1e+05 Pa becomes"))));
  EXPECT_THAT(notes(sand, test),
              Contains(AllOf(HasSubstr("cannot hold the initial stress"), HasSubstr("offset_xx = "))));
  test.initial = {100.0, 1.0}; // p_min = p_A/200 = 506.5 Pa: 406.5 Pa are missing
  EXPECT_THAT(notes(sand, test), ElementsAre(HasSubstr("offset_p = -406.5 Pa")));
}

TEST(SoilTestLimits, IsWatchedAfterEachIncrement) {
  SoilTest test = simple_shear(Monotonic{1e-3});
  std::size_t watched = 0;
  test.watch = [&](const TestProgress& progress) { watched = std::max(watched, progress.increments); };
  EXPECT_EQ(run(elastic_law, test).increments, watched);
  EXPECT_GT(watched, 0U);
}

/// K0 = 6: sin phi = 5/7; alpha = 0.6 on K0 = 0.5: sin phi = sqrt(0.25^2 + 0.6^2)/0.75. The cone of PDMY03
/// holds K0 = 6, since the stress out of plane is as high.
TEST(SoilTestNotes, SayThatNoSandIsLikeThatAtRest) {
  SoilTest test = simple_shear(Monotonic{});
  const materials::Law sand = materials::pdmy03(materials::pdmy03_recommended(0.57));
  test.initial = {100e3, 3.0};
  EXPECT_THAT(notes(sand, test), IsEmpty());
  test.initial = {100e3, 6.0};
  EXPECT_THAT(notes(sand, test), ElementsAre(HasSubstr("mobilises 45.6 degrees of friction")));
  EXPECT_THAT(notes(elastic_law, test), IsEmpty());
  test.initial = {.vertical_stress = 100e3, .k0 = 0.5, .shear_bias = 0.6, .bias_in_initial_stress = true};
  EXPECT_THAT(notes(sand, test), Contains(HasSubstr("mobilises 60.1 degrees of friction")));
}

TEST(SoilTestNotes, LeaveOutTheRatioOfPorePressureInTotalStress) {
  SoilTest test = simple_shear(Monotonic{});
  const materials::Law clay = materials::MasingShear{elastic, 1e-3};
  EXPECT_THAT(notes(clay, test), ElementsAre(HasSubstr("r_u has no meaning")));
  EXPECT_FALSE(has_pore_pressure_ratio(clay, test));
  EXPECT_TRUE(has_pore_pressure_ratio(elastic_law, test));
  test.drainage = Drainage::drained;
  EXPECT_TRUE(has_pore_pressure_ratio(clay, test));
}

} // namespace
} // namespace tremolo::soiltest
