// Cyclic direct simple shear at constant volume between two shear stresses: the number of cycles to r_u =
// 0.98 and to 1 and 3 % strain, found by an own control of the stress, against those of the reference's
// curves.

#include "pdmy03_reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace tremolo::materials::test {
namespace {

/// Cycles until something was reached first; none if never.
struct Cycles {
  std::optional<double> pressure_ratio; ///< r_u = 1 - sigma'_v/sigma'_v0 >= 0.98
  std::optional<double> one_per_cent;
  std::optional<double> three_per_cent;

  void note(double cycle, double shear_strain, double r_u) {
    const auto first = [&](std::optional<double>& when, bool reached) {
      if (reached && !when) {
        when = cycle;
      }
    };
    first(pressure_ratio, r_u >= 0.98);
    first(one_per_cent, std::abs(shear_strain) >= 0.01);
    first(three_per_cent, std::abs(shear_strain) >= 0.03);
  }
};

struct CyclicTest {
  const char* file;
  double amplitude;   ///< Pa
  double bias;        ///< Pa
  double last_strain; ///< where the test ends
};

/// Increments of 1e-5; the one that would pass the turning stress is bisected to end there.
Cycles run(const CyclicTest& test, const PointStress& initial) {
  constexpr double increment = 1e-5;
  PointTest point(pdmy03_of(test.file), initial);
  Cycles cycles;
  int half_cycle = 0; // 0 is the first quarter
  while (std::abs(point.strain().xy) < test.last_strain) {
    const double direction = half_cycle % 2 == 0 ? 1.0 : -1.0;
    const auto beyond = [&] { return direction * (point.stress().xy - test.bias) - test.amplitude; };
    const PointState before = point.now();
    const auto shear = [&](double strain) {
      point.set(before);
      point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(strain)});
      return beyond();
    };
    const bool turns = shear(direction * increment) > 0.0;
    if (turns) {
      double low = 0.0;
      double high = increment;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (shear(direction * middle) > 0.0 ? high : low) = middle;
      }
    }
    const double part = 0.25 * (1.0 + direction * (point.stress().xy - test.bias) / test.amplitude);
    const double cycle = half_cycle == 0 ? 2.0 * (part - 0.25) * 0.5 : 0.25 + 0.5 * (half_cycle - 1) + part;
    cycles.note(cycle, point.strain().xy, 1.0 - point.stress().yy / initial.yy);
    if (turns) {
      ++half_cycle;
    }
    if (half_cycle > 200) {
      break;
    }
  }
  return cycles;
}

/// From the rows of the reference, every tenth increment.
Cycles reference_cycles(const testing::ReferenceCurve& curve) {
  Cycles cycles;
  const auto cycle = curve.column("cycle");
  const auto strain = curve.column("gamma_xy");
  const auto vertical = curve.column("sig_yy");
  for (std::size_t i = 0; i < curve.size(); ++i) {
    cycles.note(cycle[i], strain[i], 1.0 - vertical[i] / vertical[0]);
  }
  return cycles;
}

void expect_same(const char* what, const std::optional<double>& ours, const std::optional<double>& theirs) {
  ASSERT_EQ(ours.has_value(), theirs.has_value()) << what;
  if (ours) {
    ::testing::Test::RecordProperty(what, std::to_string(*ours - *theirs));
    EXPECT_NEAR(*ours, *theirs, 0.05) << what; // rows lie up to 0.01 cycles apart; accepted is 1
  }
}

class CyclicStrength : public ::testing::TestWithParam<CyclicTest> {};

TEST_P(CyclicStrength, TakesAsManyCyclesAsTheReference) {
  const CyclicTest& test = GetParam();
  const testing::ReferenceCurve curve("pdmy03_" + std::string(test.file) + ".csv");
  if (curve.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  const Cycles ours = run(test, pdmy03_rows(test.file).front().stress);
  const Cycles theirs = reference_cycles(curve);
  expect_same("pressure_ratio_0.98", ours.pressure_ratio, theirs.pressure_ratio);
  expect_same("strain_1_per_cent", ours.one_per_cent, theirs.one_per_cent);
  expect_same("strain_3_per_cent", ours.three_per_cent, theirs.three_per_cent);
}

INSTANTIATE_TEST_SUITE_P(Pdmy03, CyclicStrength,
                         ::testing::Values(CyclicTest{"dr33_ucdss_csr0090_k05_s101", 9.09e3, 0.0, 0.04},
                                           CyclicTest{"dr57_ucdss_csr0160_k05_s101", 16.16e3, 0.0, 0.04},
                                           CyclicTest{"dr74_ucdss_csr0290_k05_s101", 29.29e3, 0.0, 0.04},
                                           CyclicTest{"dr57_ucdss_csr0160_k10_s101", 16.16e3, 0.0, 0.04},
                                           CyclicTest{"dr57_ucdss_bias01_csr0160", 16.16e3, 10.1e3, 0.06}),
                         [](const auto& instance) { return std::string(instance.param.file); });

} // namespace
} // namespace tremolo::materials::test
