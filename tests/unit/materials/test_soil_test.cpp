#include "materials/soiltest/cyclic/cyclic_strength.hpp"
#include "materials/soiltest/path/path_table.hpp"
#include "materials/soiltest/path/root.hpp"
#include "materials/soiltest/soil_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const materials::Elasticity elastic = {1700.0, 40e6, 0.28};
const materials::Law elastic_law = materials::LinearElastic{elastic};

SoilTest simple_shear(Loading loading) {
  SoilTest test;
  test.initial = {100e3, 0.5};
  test.loading = std::move(loading);
  return test;
}

void expect_refused(const SoilTest& test, const std::string& words, const materials::Law& law = elastic_law) {
  EXPECT_THAT([&] { run(law, test); }, ThrowsMessage<std::invalid_argument>(HasSubstr(words)));
}

TEST(SoilTestInput, RefusesWhatMakesNoSense) {
  SoilTest test = simple_shear(Monotonic{});
  test.initial.vertical_stress = -100e3;
  expect_refused(test, "vertical_stress");

  test = simple_shear(Monotonic{});
  test.initial = {.vertical_stress = 500.0, .k0 = 0.5}; // of 500 kPa; increments were halved without end
  const materials::Law sand =
      materials::pm4sand({.density = 1900.0, .relative_density = 0.55, .G_o = 500.0, .h_po = 0.5});
  expect_refused(test, "(500 kPa would be 500e3)", sand);

  test = simple_shear(Monotonic{});
  test.pore_stiffness = 1e9;
  expect_refused(test, "pore_stiffness");
  test.drainage = Drainage::undrained;
  test.pore_stiffness = 0.0;
  expect_refused(test, "pore_stiffness");

  test = simple_shear(Monotonic{});
  test.kind = Kind::oedometer;
  expect_refused(test, "constant volume");

  test = simple_shear(Monotonic{});
  test.kind = Kind::triaxial_compression;
  expect_refused(test, "plane strain", materials::MasingShear{elastic, 1e-3});
  test.initial.shear_bias = 0.1;
  expect_refused(test, "shear_bias");

  expect_refused(simple_shear(StressCycles{}), "stress_ratio");
  expect_refused(simple_shear(StrainCycles{}), "amplitude");
  expect_refused(simple_shear(Path{}), "path");
}

TEST(SoilTestInput, PathsAreReadByTheNamesOfTheirColumns) {
  std::istringstream table(
      "step, sig_yy,eps_yy,eps_xx,note,gamma_xy\r\n0,-100,0,0,7,0\n10,-90,0,1e-4,7,-2e-3\n\n");
  const Path path = read_path(table, {"sig_yy"}, 1e3);
  ASSERT_EQ(path.rows.size(), 2U);
  EXPECT_TRUE(path.by_stress[1]);
  EXPECT_EQ(path.rows[1].step, 10.0);
  EXPECT_EQ(path.rows[1].stress.yy, -90e3);
  EXPECT_EQ(path.rows[1].strain.xx, 1e-4);
  EXPECT_EQ(path.rows[1].strain.xy, -2e-3);
}

TEST(SoilTestInput, PathsThatAreIncompleteAreRefused) {
  const auto read = [](const std::string& text) {
    std::istringstream table(text);
    read_path(table);
  };
  using Refusal = std::invalid_argument;
  EXPECT_THAT([&] { read(""); }, ThrowsMessage<Refusal>(HasSubstr("empty")));
  EXPECT_THAT([&] { read("step,eps_xx,eps_yy\n"); }, ThrowsMessage<Refusal>(HasSubstr("gamma_xy")));
  EXPECT_THAT([&] { read("eps_xx,eps_yy,gamma_xy\n0,0\n"); }, ThrowsMessage<Refusal>(HasSubstr("line 2")));
  EXPECT_THAT([&] { read("eps_xx,eps_yy,gamma_xy\n0,0,1e-3x\n"); },
              ThrowsMessage<Refusal>(HasSubstr("1e-3x")));
}

TEST(SoilTestHistory, KeepsEveryNthRowAndTheEnd) {
  SoilTest test = simple_shear(Monotonic{1e-3});
  test.strain_increment = 1e-5;
  test.every = 30;
  const Result result = run(elastic_law, test);
  EXPECT_EQ(result.history.column("step"), (std::vector<double>{0, 30, 60, 90, 100}));
  EXPECT_NEAR(result.history.column("gamma_xy").back(), 1e-3, 1e-15);
  EXPECT_FALSE(result.history.has("eps_zz"));
  EXPECT_THROW(result.history.column("nothing"), std::invalid_argument);
}

/// Reversals lie exactly at tau_0 +- CSR sv, with a bias and without, and are all kept.
TEST(SoilTestCycles, ReverseExactlyAtTheStressRatio) {
  SoilTest test = simple_shear(StressCycles{0.1234, 0.06, 2.25});
  test.initial.shear_bias = 0.05;
  test.initial.bias_in_initial_stress = true;
  test.every = 1000000;
  const Result result = run(materials::MasingShear{elastic, 3e-3}, test);
  EXPECT_EQ(result.end, End::most_cycles);
  EXPECT_EQ(result.history.column("cycle"), (std::vector<double>{0.0, 0.25, 0.75, 1.25, 1.75, 2.25}));
  const std::vector<double>& tau = result.history.column("sig_xy");
  for (std::size_t i = 1; i < tau.size(); ++i) {
    EXPECT_NEAR(tau[i], 5e3 + (i % 2 == 1 ? 12.34e3 : -12.34e3), 1e-3);
  }
}

/// In between the cycle runs with the shear stress: elastic, so with the strain.
TEST(SoilTestCycles, AreInterpolatedByTheShearStress) {
  const Result result = run(elastic_law, simple_shear(StressCycles{0.1, 0.06, 1.25}));
  const std::vector<double>& tau = result.history.column("sig_xy");
  const std::vector<double>& cycle = result.history.column("cycle");
  for (std::size_t i = 0; i < tau.size(); ++i) {
    const double whole = cycle[i] < 0.25   ? tau[i] / 10e3 / 4.0
                         : cycle[i] < 0.75 ? 0.5 - tau[i] / 10e3 / 4.0
                                           : 1.0 + tau[i] / 10e3 / 4.0;
    EXPECT_NEAR(cycle[i], whole, 1e-9);
  }
}

TEST(SoilTestCycles, StartInTheSenseOfTheTest) {
  for (const Kind kind : {Kind::triaxial_compression, Kind::triaxial_extension}) {
    SoilTest test = simple_shear(StressCycles{0.1, 0.06, 0.25});
    test.kind = kind;
    test.initial.k0 = 1.0;
    const Result result = run(elastic_law, test);
    const double deviator = result.history.column("sig_xx").back() - result.history.column("sig_yy").back();
    EXPECT_NEAR(deviator, kind == Kind::triaxial_compression ? 20e3 : -20e3, 1e-3);
  }
}

/// Peak shear stress of perfectly plastic soil is below the reversal: the strain limit ends the test.
TEST(SoilTestCycles, EndAtTheStrainLimitWhereTheStressIsNotReached) {
  materials::MohrCoulomb soil;
  soil.elastic = elastic;
  soil.friction_peak = soil.friction_residual = 0.5;
  const Result result = run(soil, simple_shear(StressCycles{0.8, 0.02}));
  EXPECT_EQ(result.end, End::largest_strain);
  EXPECT_LT(result.cycles, 0.25);
  EXPECT_NEAR(result.largest_strain, 0.02, 1.1e-5);
  EXPECT_TRUE(std::isnan(result.cycles_to.strain_3pc));
}

/// The way the law cannot go on is the end of the test, not of what it has given so far.
TEST(SoilTestEnd, ReturnsWhatItHasWhenALoadCannotBeCarried) {
  materials::MohrCoulomb soil;
  soil.elastic = elastic;
  soil.friction_peak = soil.friction_residual = 0.5;
  Path path;
  path.by_stress = {false, true, true, false};
  path.rows.resize(2);
  path.rows[0].stress = {-50e3, -100e3, -50e3, 0.0};
  path.rows[1].stress = {-50e3, -100e3, -50e3, 100e3};
  path.rows[1].step = 1000.0;
  SoilTest test = simple_shear(path);
  test.kind = Kind::path;
  test.drainage = Drainage::drained;
  const Result result = run(soil, test);
  EXPECT_EQ(result.end, End::refused);
  EXPECT_THAT(result.end_reason, HasSubstr("peak load"));
  const double strength = 100e3 * std::sin(0.5); // psi = 0
  EXPECT_NEAR(result.history.column("sig_xy").back(), strength, 0.1e3);
  EXPECT_EQ(static_cast<double>(result.history.rows()), result.history.column("step").back() + 1.0);
}

/// Static shear by drained shearing: tau_0 at zero strain, vertical stress untouched.
TEST(SoilTestEnd, StartsFromADrainedBias) {
  SoilTest test = simple_shear(Monotonic{1e-4});
  test.initial.shear_bias = 0.1;
  const Result result = run(materials::MasingShear{elastic, 1e-3}, test);
  EXPECT_NEAR(result.history.column("sig_xy").front(), 10e3, 1e-3);
  EXPECT_EQ(result.history.column("gamma_xy").front(), 0.0);
  EXPECT_NEAR(result.history.column("sig_yy").front(), -100e3, 1e-5);
  test.initial.shear_bias = 2.0; // more than its strength
  materials::MohrCoulomb soil;
  soil.elastic = elastic;
  soil.friction_peak = soil.friction_residual = 0.5;
  EXPECT_THROW(run(soil, test), std::invalid_argument);
}

TEST(Root, OfASmoothFunctionAndOfAJump) {
  const auto cubic = [](double x) { return x * x * x - 2.0; };
  const Root smooth = find_root(cubic, {1.0, 0.1, 10.0, 3.0, 1e-6});
  EXPECT_TRUE(smooth.found);
  EXPECT_NEAR(smooth.x, std::cbrt(2.0), 1e-6);
  EXPECT_LT(smooth.evaluations, 15);
  const auto jump = [](double x) { return x < 3.3 ? -1.0 : 0.5; };
  const Root at_jump = find_root(jump, {1.0, 0.1, 10.0, 1.0, 1e-4});
  EXPECT_TRUE(at_jump.found);
  EXPECT_NEAR(at_jump.x, 3.3, 2e-4);
  EXPECT_EQ(at_jump.value, 0.5);
}

TEST(Root, SaysThatThereIsNone) {
  const Root none = find_root([](double x) { return 1.0 + x; }, {1.0, 0.1, 10.0, 1.0, 1e-6});
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.x, 0.1);
  const auto fails = [](double x) -> double {
    if (x > 2.0) {
      throw std::runtime_error("too far");
    }
    return -1.0;
  };
  EXPECT_THROW(find_root(fails, {1.0, 0.1, 10.0, 1.0, 1e-6}), std::runtime_error);
}

} // namespace
} // namespace tremolo::soiltest
