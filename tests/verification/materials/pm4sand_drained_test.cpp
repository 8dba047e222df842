// Drained tests of PM4Sand under mixed control against an independent implementation (a replay of its strains
// would be ill-conditioned): peak shear strength within 1 per cent, secant modulus 3, damping 5, volumetric
// strain 3 (monotonic) and 5 (cyclic, from 0.1 per cent strain) per cent.

#include "tests/support/pm4sand_soil.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tremolo::materials::test {
namespace {

/// A curve of (strain, stress) with the volumetric strain at its end.
struct Curve {
  std::vector<double> strain;
  std::vector<double> stress; ///< Pa
  double volumetric = 0.0;    ///< tension positive
};

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Simple shear at constant vertical stress with strains given row by row.
Curve drained_shear(const Law& law, const PointStress& initial, const std::vector<double>& strains) {
  PointTest point(law, initial);
  Curve curve{{0.0}, {initial.xy}};
  for (std::size_t i = 1; i < strains.size(); ++i) {
    point.apply(
        {Control::strain(0.0), Control::stress(initial.yy), Control::strain(strains[i] - strains[i - 1])});
    curve.strain.push_back(strains[i]);
    curve.stress.push_back(point.stress().xy);
  }
  curve.volumetric = point.strain().yy;
  return curve;
}

/// Plane-strain compression at constant horizontal stress.
Curve drained_compression(const Law& law, const PointStress& initial, double increment, double end) {
  PointTest point(law, initial);
  Curve curve{{0.0}, {initial.xx - initial.yy}};
  for (int i = 0; i < std::lround(end / increment); ++i) {
    point.apply({Control::stress(initial.xx), Control::strain(-increment)});
    curve.strain.push_back(-point.strain().yy);
    curve.stress.push_back(point.stress().xx - point.stress().yy);
  }
  curve.volumetric = point.strain().xx + point.strain().yy;
  return curve;
}

std::vector<double> ramp(double increment, double end) {
  std::vector<double> strains;
  for (int i = 0; i <= std::lround(end / increment); ++i) {
    strains.push_back(i * increment);
  }
  return strains;
}

struct Monotonic {
  const char* file;
  bool shear; ///< simple shear, else compression
};

class Pm4Drained : public ::testing::TestWithParam<Monotonic> {};

TEST_P(Pm4Drained, HasThePeakAndTheDilationOfTheReference) {
  const Monotonic& test = GetParam();
  const Pm4Reference reference(std::string("pm4_dr55_mono_") + test.file);
  if (reference.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  std::vector<double> stress = reference.sxy;
  if (!test.shear) {
    for (std::size_t i = 0; i < stress.size(); ++i) {
      stress[i] = reference.sxx[i] - reference.syy[i];
    }
  }
  const double volumetric = reference.exx.back() + reference.eyy.back();
  const Pm4Sand law = report_sand(55);
  constexpr double increment = 1e-5;
  const Curve ours = test.shear
                         ? drained_shear(law, reference.stress(0), ramp(increment, reference.gxy.back()))
                         : drained_compression(law, reference.stress(0), increment, -reference.eyy.back());
  EXPECT_NEAR(largest(ours.stress), largest(stress), 0.01 * largest(stress));
  EXPECT_NEAR(ours.stress.back(), stress.back(), 0.01 * stress.back());
  EXPECT_NEAR(ours.volumetric, volumetric, 0.03 * volumetric);
  RecordProperty("peak", std::to_string(largest(ours.stress) / largest(stress) - 1.0));
  RecordProperty("end", std::to_string(ours.stress.back() / stress.back() - 1.0));
  RecordProperty("volumetric", std::to_string(ours.volumetric / volumetric - 1.0));
}

INSTANTIATE_TEST_SUITE_P(
    Reference, Pm4Drained,
    ::testing::Values(Monotonic{"dss_d_p25_k05", true}, Monotonic{"dss_d_p100_k05", true},
                      Monotonic{"dss_d_p400_k05", true}, Monotonic{"psc_d_p25_k10", false},
                      Monotonic{"psc_d_p100_k10", false}, Monotonic{"psc_d_p400_k10", false}));

/// Secant modulus and damping ratio of the last full loop of an amplitude, and the volumetric strain there.
struct Loop {
  double secant = 0.0;  ///< Pa
  double damping = 0.0; ///< 1
  double volumetric = 0.0;
};

/// @param end  row at which the loop closes
Loop loop_ending_at(const std::vector<double>& strain, const std::vector<double>& stress,
                    const std::vector<double>& volumetric, double amplitude, std::size_t begin,
                    std::size_t end) {
  Loop loop;
  double area = 0.0;
  double highest = stress[begin];
  double lowest = stress[begin];
  for (std::size_t i = begin + 1; i <= end; ++i) {
    area += 0.5 * (stress[i] + stress[i - 1]) * (strain[i] - strain[i - 1]);
    highest = std::max(highest, stress[i]);
    lowest = std::min(lowest, stress[i]);
  }
  loop.secant = (highest - lowest) / (2.0 * amplitude);
  loop.damping = area / (2.0 * std::numbers::pi * loop.secant * amplitude * amplitude);
  loop.volumetric = volumetric[end];
  return loop;
}

/// The last reversal from +amplitude before the strain grows beyond: the last loop begins four quarters
/// before.
std::size_t last_peak(const std::vector<double>& strain, double amplitude) {
  std::size_t peak = 0;
  for (std::size_t i = 1; i + 1 < strain.size() && std::abs(strain[i]) < 1.01 * amplitude; ++i) {
    if (strain[i] > strain[i - 1] && strain[i] > strain[i + 1]) {
      peak = i;
    }
  }
  return peak;
}

TEST(Pm4DrainedCycles, HaveTheLoopsOfTheReference) {
  const Pm4Reference reference("pm4_dr55_dcdss_s100");
  if (reference.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  PointTest point(report_sand(55), reference.stress(0));
  std::vector<double> stress = {0.0};
  std::vector<double> volumetric = {0.0};
  for (std::size_t i = 1; i < reference.size(); ++i) {
    point.apply({Control::strain(0.0), Control::stress(reference.syy[0]),
                 Control::strain(reference.gxy[i] - reference.gxy[i - 1])});
    stress.push_back(point.stress().xy);
    volumetric.push_back(point.strain().yy);
  }
  constexpr double increment = 1e-5;
  for (const double amplitude : {1e-5, 1e-4, 1e-3, 1e-2}) {
    const auto quarter = static_cast<std::size_t>(std::lround(amplitude / increment));
    const std::size_t end = last_peak(reference.gxy, amplitude);
    const std::size_t begin = end - 4 * quarter;
    const Loop theirs = loop_ending_at(reference.gxy, reference.sxy, reference.eyy, amplitude, begin, end);
    const Loop ours = loop_ending_at(reference.gxy, stress, volumetric, amplitude, begin, end);
    RecordProperty("secant_at_" + std::to_string(amplitude),
                   std::to_string(ours.secant / theirs.secant - 1.0));
    RecordProperty("damping_at_" + std::to_string(amplitude),
                   std::to_string(ours.damping) + " " + std::to_string(theirs.damping));
    RecordProperty("volumetric_at_" + std::to_string(amplitude),
                   std::to_string(ours.volumetric) + " " + std::to_string(theirs.volumetric));
    EXPECT_NEAR(ours.secant, theirs.secant, 0.03 * theirs.secant) << amplitude;
    EXPECT_NEAR(ours.damping, theirs.damping, 0.05 * theirs.damping) << amplitude;
    if (amplitude >= 1e-3) {
      EXPECT_NEAR(ours.volumetric, theirs.volumetric, 0.05 * std::abs(theirs.volumetric)) << amplitude;
    }
  }
}

} // namespace
} // namespace tremolo::materials::test
