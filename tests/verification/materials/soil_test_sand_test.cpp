// Cyclic soil tests on liquefiable sand against those of an independent implementation (OpenSees), as it
// printed them, and the contraction parameter of PM4Sand by calibration.

#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/sand/pm4sand/pm4sand.hpp"
#include "materials/soiltest/cyclic/calibrate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo::soiltest {
namespace {

using materials::Law;
using materials::pdmy03;
using materials::pdmy03_recommended;

constexpr double atmosphere = 101.3e3; // Pa

Law sand(double relative_density, double shear_coefficient, double contraction) {
  materials::Pm4SandInput input;
  input.density = 1900.0;
  input.relative_density = relative_density;
  input.G_o = shear_coefficient;
  input.h_po = contraction;
  return pm4sand(input);
}

/// Volumetric strain (compression negative) of a drained simple shear test of loose PDMY03 sand to 0.5 %.
Result drained_shear(double vertical_stress, double increment) {
  SoilTest test;
  test.drainage = Drainage::drained;
  test.initial = {vertical_stress, 1.0};
  test.loading = Monotonic{0.005};
  test.strain_increment = increment;
  test.every = 1000;
  return run(pdmy03(pdmy03_recommended(0.33)), test);
}

double volume(const Result& result) {
  return result.history.column("eps_yy").back();
}

// At 50 kPa the stress is held by four strains of an increment; only with the default increment did Newton's
// method find a far one, which contracts 24 % more. At 200 kPa no root is near at a strain of 0.00133.
TEST(DrainedShear, ContractsAlikeInLargeAndInSmallIncrements) {
  const auto low = drained_shear(50e3, 1e-5);
  EXPECT_NEAR(volume(low) / volume(drained_shear(50e3, 2e-6)), 1.0, 0.01);
  EXPECT_EQ(low.leaps.count, 0U);

  const auto high = drained_shear(200e3, 1e-5);
  EXPECT_NEAR(volume(high) / volume(drained_shear(200e3, 2e-6)), 1.0, 0.02);
  ASSERT_GT(high.leaps.count, 0U);
  EXPECT_NEAR(high.leaps.first.xy, 0.00133, 1e-5);
  EXPECT_NEAR(high.leaps.largest, 1.5e-5, 0.1e-5);
  EXPECT_LT(high.leaps.steps_away, 10U);
}

SoilTest simple_shear(double vertical_stress, double stress_ratio) {
  SoilTest test;
  test.initial = {vertical_stress, 0.5};
  StressCycles loading;
  loading.stress_ratio = stress_ratio;
  loading.largest_strain = 0.035;
  test.loading = loading;
  test.every = 1000;
  return test;
}

/// Cycles to r_u = 0.98 and to 1, 3 and (double amplitude) 5 % strain.
void expect_cycles(const Result& result, const CyclesTo& reference) {
  const CyclesTo& ours = result.cycles_to;
  constexpr double tolerance = 0.05;
  if (std::isnan(reference.ru_98)) {
    EXPECT_TRUE(std::isnan(ours.ru_98));
  } else {
    EXPECT_NEAR(ours.ru_98, reference.ru_98, tolerance);
  }
  EXPECT_NEAR(ours.strain_1pc, reference.strain_1pc, tolerance);
  EXPECT_NEAR(ours.strain_3pc, reference.strain_3pc, tolerance);
  EXPECT_NEAR(ours.double_amplitude_5pc, reference.double_amplitude_5pc, tolerance);
}

CyclesTo cycles_to(double ru, double one, double three, double double_five) {
  CyclesTo to;
  to.ru_98 = ru;
  to.strain_1pc = one;
  to.strain_3pc = three;
  to.double_amplitude_5pc = double_five;
  return to;
}

TEST(SoilTestOfSand, Pm4SandLiquefiesInTheCyclesOfTheReference) {
  expect_cycles(run(sand(0.35, 476, 0.53), simple_shear(atmosphere, 0.090)),
                cycles_to(13.51, 13.17, 13.74, 14.16));
  expect_cycles(run(sand(0.55, 677, 0.40), simple_shear(atmosphere, 0.147)),
                cycles_to(12.01, 12.14, 14.19, 13.70));
  expect_cycles(run(sand(0.75, 890, 0.63), simple_shear(atmosphere, 0.312)),
                cycles_to(11.01, 10.20, 13.71, 12.72));
}

TEST(SoilTestOfSand, Pm4SandWithAStaticBiasAndWithEqualStresses) {
  SoilTest biased = simple_shear(atmosphere, 0.147);
  biased.initial.shear_bias = 0.1;
  biased.initial.bias_in_initial_stress = true;
  std::get<StressCycles>(biased.loading).largest_strain = 0.06;
  expect_cycles(run(sand(0.55, 677, 0.40), biased), cycles_to(12.67, 11.14, 12.90, 13.15));
  SoilTest isotropic = simple_shear(100e3, 0.160);
  isotropic.initial.k0 = 1.0;
  expect_cycles(run(sand(0.55, 677, 0.40), isotropic), cycles_to(24.50, 24.19, 26.22, 25.74));
}

TEST(SoilTestOfSand, Pdmy03ReachesStrainsInTheCyclesOfTheReference) {
  const double never = CyclesTo::never;
  SoilTest loose = simple_shear(101e3, 0.090);
  std::get<StressCycles>(loose.loading).largest_strain = 0.04;
  expect_cycles(run(pdmy03(pdmy03_recommended(0.33)), loose), cycles_to(12.01, 11.21, 12.17, 12.13));
  expect_cycles(run(pdmy03(pdmy03_recommended(0.57)), simple_shear(101e3, 0.160)),
                cycles_to(never, 11.70, 13.67, 13.22));
  expect_cycles(run(pdmy03(pdmy03_recommended(0.74)), simple_shear(101e3, 0.290)),
                cycles_to(never, 10.74, 14.71, 14.18));
}

/// The cycles do not depend on the increment of the test: the law cuts it as it needs.
TEST(SoilTestOfSand, IncrementsOfTheTestDoNotMatter) {
  SoilTest coarse = simple_shear(atmosphere, 0.147);
  coarse.strain_increment = 1e-4;
  expect_cycles(run(sand(0.55, 677, 0.40), coarse), cycles_to(12.01, 12.14, 14.19, 13.70));
}

/// Pore water brings the constant volume as it stiffens; real water (2.2 GPa, n = 0.4) costs half a cycle.
TEST(SoilTestOfSand, UndrainedComesToConstantVolumeAsTheWaterStiffens) {
  SoilTest test = simple_shear(atmosphere, 0.147);
  test.drainage = Drainage::undrained;
  test.pore_stiffness = 2.2e11;
  const Law law = sand(0.55, 677, 0.40);
  expect_cycles(run(law, test), cycles_to(12.01, 12.14, 14.19, 13.70));
  test.pore_stiffness = 2.2e9 / 0.4;
  const Result real = run(law, test);
  EXPECT_GT(real.cycles_to.strain_3pc, 14.3);
  EXPECT_LT(real.cycles_to.strain_3pc, 15.2);
  EXPECT_EQ(real.largest_missing_stress, 0.0);
}

/// Peak |tau| (Pa) at constant volume and drained.
struct Peaks {
  double constant_volume;
  double drained;
};

void expect_peaks(const Law& law, SoilTest test, const Peaks& reference) {
  test.every = 1000;
  test.drainage = Drainage::constant_volume;
  EXPECT_NEAR(run(law, test).peak_shear_stress / reference.constant_volume, 1.0, 0.03) << name(test.kind);
  test.drainage = Drainage::drained;
  EXPECT_NEAR(run(law, test).peak_shear_stress / reference.drained, 1.0, 0.01) << name(test.kind);
}

TEST(SoilTestOfSand, MonotonicStrengths) {
  SoilTest compression;
  compression.kind = Kind::plane_strain_compression;
  compression.initial = {100e3, 1.0};
  compression.loading = Monotonic{0.08};
  const Law pm4 = sand(0.55, 677, 0.40);
  const Law multi_yield = pdmy03(pdmy03_recommended(0.57));
  expect_peaks(pm4, compression, {0.5 * 1189.99e3, 0.5 * 308.957e3});
  expect_peaks(multi_yield, compression, {0.5 * 8427.28e3, 0.5 * 497.757e3});

  SoilTest shear;
  shear.initial = {400e3 / 3.0, 0.5};
  shear.loading = Monotonic{0.1};
  expect_peaks(pm4, shear, {428.782e3, 86.8124e3});
  shear.initial.vertical_stress = 150e3;
  expect_peaks(multi_yield, shear, {1061.59e3, 109.817e3});
}

struct PrintedLoop {
  double amplitude;
  double modulus; ///< Pa
  double damping;
};

void expect_loops(const Result& result, const std::vector<PrintedLoop>& reference) {
  ASSERT_EQ(result.loops.size(), 2 * reference.size());
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const Loop& loop = result.loops[2 * i + 1]; // the second cycle of each amplitude
    EXPECT_DOUBLE_EQ(loop.amplitude, reference[i].amplitude);
    EXPECT_NEAR(loop.modulus / reference[i].modulus, 1.0, 0.03) << loop.amplitude;
    EXPECT_NEAR(loop.damping / reference[i].damping, 1.0, 0.05) << loop.amplitude;
  }
}

TEST(SoilTestOfSand, StrainCyclesAtConstantVolume) {
  SoilTest test = simple_shear(100e3, 0.1);
  test.loading = StrainCycles{{1e-4, 5e-4, 1e-3, 5e-3}, 2};
  test.strain_increment = 5e-6;
  expect_loops(run(sand(0.55, 677, 0.40), test), {{1e-4, 43206.9e3, 0.0661},
                                                  {5e-4, 24086.4e3, 0.1472},
                                                  {1e-3, 16471.1e3, 0.1831},
                                                  {5e-3, 1924.68e3, 0.1084}});
  test.strain_increment = 1e-5;
  expect_loops(run(pdmy03(pdmy03_recommended(0.57)), test), {{1e-4, 54491e3, 0.0226},
                                                             {5e-4, 33350.4e3, 0.1040},
                                                             {1e-3, 17464.6e3, 0.1829},
                                                             {5e-3, 2500.17e3, 0.3507}});
}

TEST(SoilTestOfSand, DrainedStrainCycles) {
  SoilTest test = simple_shear(100e3, 0.1);
  test.drainage = Drainage::drained;
  test.loading = StrainCycles{{1e-4, 1e-3, 1e-2}, 2};
  const Result pm4 = run(sand(0.55, 677, 0.40), test);
  expect_loops(pm4, {{1e-4, 44135.2e3, 0.0647}, {1e-3, 20812.3e3, 0.1787}, {1e-2, 4994.49e3, 0.3346}});
  EXPECT_EQ(pm4.largest_missing_stress, 0.0);
  EXPECT_LT(static_cast<double>(pm4.updates), 5.0 * static_cast<double>(pm4.increments));

  // After a reversal at 1 % the contraction of PDMY03 is so strong that no strain holds the vertical stress:
  // it is said by how much it was missed, and the test goes on.
  test.loading = StrainCycles{{1e-4, 1e-3}, 2};
  const Law law = pdmy03(pdmy03_recommended(0.57));
  const Result small = run(law, test);
  expect_loops(small, {{1e-4, 56066.8e3, 0.0227}, {1e-3, 33376.8e3, 0.1562}});
  EXPECT_EQ(small.largest_missing_stress, 0.0);
  test.loading = StrainCycles{{1e-2}, 2};
  const Result large = run(law, test);
  EXPECT_EQ(large.end, End::completed);
  EXPECT_GT(large.largest_missing_stress, 1.0);
  EXPECT_LT(large.largest_missing_stress, 0.02 * 100e3);
}

Calibration contraction(double relative_density, double shear_coefficient, double stress_ratio,
                        double cycles) {
  SoilTest test = simple_shear(atmosphere, stress_ratio);
  test.strain_increment = 1e-4;
  return calibrate([&](double h_po) { return sand(relative_density, shear_coefficient, h_po); }, test,
                   {stress_ratio, cycles, Criterion::strain_3pc}, {0.5, 0.02, 5.0});
}

/// At the strength for 15 cycles that the reference has with h_po = 0.53, 0.40 and 0.63, these come back.
TEST(CalibrationOfPm4Sand, ComesBackToTheParametersOfTheReference) {
  EXPECT_NEAR(contraction(0.35, 476, 0.0881, 15.0).parameter / 0.53, 1.0, 0.01);
  EXPECT_NEAR(contraction(0.55, 677, 0.1446, 15.0).parameter / 0.40, 1.0, 0.01);
  EXPECT_NEAR(contraction(0.75, 890, 0.3016, 15.0).parameter / 0.63, 1.0, 0.01);
}

/// The published sets and the strengths of Idriss & Boulanger: 3 % in the fifteenth cycle, that is after 14.
TEST(CalibrationOfPm4Sand, ReproducesThePublishedSets) {
  EXPECT_NEAR(contraction(0.35, 476, 0.090, 14.0).parameter / 0.53, 1.0, 0.1);
  EXPECT_NEAR(contraction(0.55, 677, 0.147, 14.0).parameter / 0.40, 1.0, 0.1);
  EXPECT_NEAR(contraction(0.75, 890, 0.312, 14.0).parameter / 0.63, 1.0, 0.1);
}

/// Hostun sand at D_R = 45 %: about 0.50 by interpolation between strengths of the reference.
TEST(CalibrationOfPm4Sand, FindsASetForHostunSand) {
  const Calibration fit = contraction(0.45, 574, 0.113, 15.0);
  EXPECT_NEAR(fit.parameter / 0.50, 1.0, 0.1);
  EXPECT_NEAR(fit.cycles, 15.0, 0.5);
  EXPECT_NEAR(fit.strength_error, 0.0, 0.005);
  EXPECT_LT(fit.tests, 25);
}

/// Drained sand reaches 3 % in the first cycle or never: no rate makes it five.
TEST(CalibrationOfPm4Sand, RefusesACountThatJumpsPastTheTarget) {
  SoilTest test = simple_shear(atmosphere, 0.5);
  test.drainage = Drainage::drained;
  test.strain_increment = 4e-4;
  EXPECT_THROW(calibrate([](double h_po) { return sand(0.35, 476, h_po); }, test,
                         {0.5, 5.0, Criterion::strain_3pc}, {0.53, 0.01, 10.0}),
               std::runtime_error);
}

} // namespace
} // namespace tremolo::soiltest
