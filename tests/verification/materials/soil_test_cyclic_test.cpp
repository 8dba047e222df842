// Cyclic soil tests on a hyperbolic law with Masing loops, whose answers are closed forms.

#include "soils.hpp"

#include "materials/soiltest/cyclic/calibrate.hpp"
#include "materials/soiltest/cyclic/cyclic_strength.hpp"
#include "materials/soiltest/cyclic/modulus_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

constexpr double vertical = 100e3; // Pa
constexpr double modulus = 40e6;   // G0, Pa
constexpr double reference = 1e-3; // gamma_r
constexpr double ratio = 0.3;      // CSR below the strength G0 gamma_r = 0.4 sv

materials::MasingShear hyperbola(double reference_strain) {
  return {{1700.0, 2.0 * 1.3 * modulus, 0.3}, reference_strain, 1.0, 1.0};
}

/// Strain at a shear stress on the hyperbola.
double strain_at(double tau, double reference_strain) {
  return tau / (modulus - tau / reference_strain);
}

/// Cycles, less than a quarter, at which the first loading to a stress ratio reaches a strain.
double quarter_cycles(double strain, double stress_ratio, double reference_strain) {
  const double tau = modulus * strain / (1.0 + strain / reference_strain);
  return 0.25 * tau / (stress_ratio * vertical);
}

SoilTest simple_shear(double stress_ratio) {
  SoilTest test;
  test.drainage = Drainage::drained;
  test.initial = {vertical, 0.5};
  test.loading = StressCycles{stress_ratio, 0.06, 3.0};
  test.strain_increment = 2e-5;
  return test;
}

/// Loops between +-CSR sv close: the strain at every reversal is the backbone's.
TEST(CyclicSoilTest, MasingLoopsCloseAtTheBackbone) {
  SoilTest test = simple_shear(ratio);
  test.every = 1000000;
  const Result result = run(hyperbola(reference), test);
  EXPECT_EQ(result.end, End::most_cycles);
  const double strain = strain_at(ratio * vertical, reference);
  const std::vector<double>& gamma = result.history.column("gamma_xy");
  ASSERT_EQ(gamma.size(), 8U); // start, 6 reversals, a last half of a half cycle
  for (std::size_t i = 1; i < 7; ++i) {
    EXPECT_NEAR(gamma[i], i % 2 == 1 ? strain : -strain, 1e-9);
  }
  EXPECT_TRUE(std::isnan(result.cycles_to.strain_1pc));
}

/// Strains passed on the way to the first reversal, at a part of the first quarter cycle that is known.
TEST(CyclicSoilTest, CountsPartsOfACycle) {
  const double high = 0.39; // 97.5 % of the strength: the reversal is at 3.9 % strain
  const Result result = run(hyperbola(reference), simple_shear(high));
  EXPECT_NEAR(result.cycles_to.strain_1pc, quarter_cycles(0.01, high, reference), 1e-6);
  EXPECT_NEAR(result.cycles_to.strain_3pc, quarter_cycles(0.03, high, reference), 1e-6);
  EXPECT_TRUE(std::isnan(result.cycles_to.strain_5pc));
  // 5 % double amplitude: on the first unloading, twice the backbone from the reversal.
  const double unloaded = 2.0 * modulus * 0.025 / (1.0 + 0.025 / reference);
  EXPECT_NEAR(result.cycles_to.double_amplitude_5pc, 0.25 + 0.5 * unloaded / (2.0 * high * vertical), 1e-5);
}

/// Undrained soil that softens before the first reversal: its stress falls, its cycles do not run backwards.
TEST(CyclicSoilTest, CyclesNeverRunBackwards) {
  SoilTest test = simple_shear(0.6);
  test.drainage = Drainage::undrained;
  test.pore_stiffness = 5e9;
  std::get<StressCycles>(test.loading).largest_strain = 0.06;
  const Result result = run(materials::test::slope_soil(), test);
  const std::vector<double>& tau = result.history.column("sig_xy");
  ASSERT_LT(tau.back(), 0.95 * result.peak_shear_stress) << "the test must soften";
  EXPECT_TRUE(std::ranges::is_sorted(result.history.column("cycle")));
  EXPECT_LE(result.cycles_to.strain_1pc, result.cycles_to.strain_3pc);
  EXPECT_LE(result.cycles_to.strain_3pc, result.cycles_to.strain_5pc);
}

TEST(CyclicSoilTest, ModulusAndDampingAreThoseOfMasing) {
  const std::vector<double> amplitudes = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2};
  SoilTest test = simple_shear(ratio);
  for (const double exponent : {1.0, 0.8}) {
    materials::MasingShear law = hyperbola(reference);
    law.exponent = exponent;
    const ModulusCurve curve = modulus_curve(law, test, amplitudes, 2, 200);
    for (const ModulusPoint& point : curve.points) {
      const double secant = law.backbone().secant(point.amplitude);
      EXPECT_NEAR(point.modulus / secant, 1.0, 1e-6);
      EXPECT_NEAR(point.modulus_ratio, secant / law.backbone().secant(1e-7), 1e-6);
      EXPECT_NEAR(point.damping, masing_damping(law.backbone(), point.amplitude), 1e-4) << point.amplitude;
    }
  }
}

/// The tests behind a curve come with it, so that nobody runs them again for their histories.
TEST(CyclicSoilTest, ModulusCurveKeepsItsTests) {
  const std::vector<double> amplitudes = {1e-4, 1e-3};
  const ModulusCurve curve = modulus_curve(hyperbola(reference), simple_shear(ratio), amplitudes, 2);
  ASSERT_EQ(curve.tests.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(curve.tests[i].loops.back().modulus, curve.points[i].modulus);
    EXPECT_GT(curve.tests[i].history.rows(), 400U);
    EXPECT_NEAR(std::ranges::max(curve.tests[i].history.column("gamma_xy")), amplitudes[i], 1e-15);
  }
}

/// Coarser loops lose area in the second order of the increment.
TEST(CyclicSoilTest, DampingConvergesInTheSecondOrder) {
  SoilTest test = simple_shear(ratio);
  test.strain_increment = 1e-3;
  const std::vector<double> amplitude = {1e-3};
  const double exact = masing_damping(hyperbola(reference).backbone(), 1e-3);
  const auto error = [&](int increments) {
    return std::abs(
        modulus_curve(hyperbola(reference), test, amplitude, 2, increments).points.front().damping - exact);
  };
  EXPECT_NEAR(std::log2(error(20) / error(40)), 2.0, 0.1);
  EXPECT_NEAR(std::log2(error(40) / error(80)), 2.0, 0.1);
}

/// The stress ratio that reaches 1 % in a fifth of a cycle.
TEST(CyclicSoilTest, FindsTheStressRatioForANumberOfCycles) {
  const CyclicStrength found =
      cyclic_strength(hyperbola(reference), simple_shear(0.6), 0.2, Criterion::strain_1pc);
  const double exact = quarter_cycles(0.01, 1.0, reference) / 0.2;
  EXPECT_NEAR(found.stress_ratio / exact, 1.0, 1e-3);
  EXPECT_NEAR(found.cycles, 0.2, 2e-4);
  EXPECT_LT(found.tests, 12);
  EXPECT_GT(found.updates, 0U);
}

/// N = 1/4 tau(gamma)/(CSR sv) grows with gamma_r: the reference strain for a wanted N by calibration.
TEST(CyclicSoilTest, CalibratesAParameter) {
  constexpr double stress_ratio = 0.475; // above tau(3 %), so that it is reached in the first quarter
  const double wanted = quarter_cycles(0.03, stress_ratio, 1.2e-3);
  const Calibration fit =
      calibrate([](double parameter) { return hyperbola(parameter); }, simple_shear(ratio),
                {stress_ratio, wanted, Criterion::strain_3pc}, {8e-4, 1e-4, 1e-2});
  EXPECT_NEAR(fit.parameter / 1.2e-3, 1.0, 5e-3);
  EXPECT_NEAR(fit.cycles / wanted, 1.0, 5e-3);
  EXPECT_NEAR(fit.strength_error, 0.0, 6e-3);
  const auto out_of_reach = [&] {
    calibrate([](double parameter) { return hyperbola(parameter); }, simple_shear(ratio),
              {stress_ratio, wanted, Criterion::strain_3pc}, {8e-4, 1e-4, 1e-3});
  };
  EXPECT_THROW(out_of_reach(), std::runtime_error);
}

/// Values of Idriss & Boulanger (2008): 0.090, 0.147 and 0.312 at D_R = 35, 55 and 75 %.
TEST(CyclicStrengthTarget, IsThatOfIdrissAndBoulanger) {
  EXPECT_NEAR(idriss_boulanger_strength(blow_count(0.35)), 0.090, 5e-4);
  EXPECT_NEAR(idriss_boulanger_strength(blow_count(0.55)), 0.147, 5e-4);
  EXPECT_NEAR(idriss_boulanger_strength(blow_count(0.75)), 0.312, 5e-4);
  EXPECT_NEAR(idriss_boulanger_strength(14.0, 30.0) / idriss_boulanger_strength(14.0), std::pow(0.5, 0.34),
              1e-12);
}

} // namespace
} // namespace tremolo::soiltest
