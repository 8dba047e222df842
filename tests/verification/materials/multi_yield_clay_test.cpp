// Clay of nested von Mises surfaces: undrained strength in every condition, backbone, Masing rules, initial
// shear stress, curves of the user's.

#include "materials/law/driver.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tremolo::materials {
namespace {

const Elasticity elastic = {1700.0, 2.0 * 1.495 * 30e6, 0.495}; // G = 30 MPa
constexpr double s_u = 60e3;

PointStep shear(double change) {
  return {Control::strain(0.0), Control::strain(0.0), Control::strain(change)};
}

void shear_to(PointTest& point, double strain, int steps) {
  const double change = (strain - point.strain().xy) / steps;
  for (int n = 0; n < steps; ++n) {
    point.apply(shear(change));
  }
}

TEST(MultiYieldClay, ReachesItsStrengthInSimpleShearAtThePeakStrain) {
  for (const double peak_strain : {0.01, 0.1}) {
    for (const std::size_t surfaces : {4u, 8u, 20u, 60u}) {
      const MultiYieldClay clay = multi_yield_clay(elastic, s_u, {surfaces, peak_strain});
      PointTest point(clay, {-80e3, -80e3, -80e3, 0.0});
      shear_to(point, 0.5 * peak_strain, 50);
      EXPECT_LT(point.stress().xy, 0.999 * s_u);
      shear_to(point, peak_strain, 50);
      EXPECT_NEAR(point.stress().xy, s_u, 1e-10 * s_u);
      shear_to(point, 5.0 * peak_strain, 10);
      EXPECT_NEAR(point.stress().xy, s_u, 1e-10 * s_u);
      EXPECT_NEAR(point.stress().yy, -80e3, 1e-6);
    }
  }
}

/// tau = G gamma/(1 + gamma/gamma_r) through (gamma_p, s_u), within the sag of the polygon's sides.
TEST(MultiYieldClay, FollowsTheHyperbolaOfStiffnessAndStrength) {
  const double reference = 0.1 * s_u / (3e6 - s_u);
  for (const std::size_t surfaces : {12u, 20u, 40u}) {
    const MultiYieldClay clay = multi_yield_clay(elastic, s_u, {surfaces, 0.1});
    const double side = std::numbers::sqrt2 * std::numbers::pi / static_cast<double>(surfaces - 1);
    for (double strain = 1e-8; strain < 0.0999; strain *= 1.01) {
      const double hyperbola = 30e6 * strain / (1.0 + strain / reference);
      EXPECT_NEAR(monotonic_stress(clay, strain) / hyperbola, 1.0, 1.05 * side * side / 16.0);
    }
    EXPECT_NEAR(monotonic_stress(clay, 1e-9) / 1e-9, 30e6, 1e-6);
  }
}

/// sqrt(3) s_u in triaxial compression and extension, 2 s_u in plane strain, whatever the pressure.
TEST(MultiYieldClay, StrengthIsVonMisesAndIndependentOfPressure) {
  const MultiYieldClay clay = multi_yield_clay(elastic, s_u);
  for (const double cell : {0.0, 100e3, 2e6}) {
    for (const bool triaxial : {true, false}) {
      for (const double axial : {-0.2, 0.2}) {
        PointTest point(clay, {-cell, -cell, -cell, 0.0});
        for (int n = 0; n < 100; ++n) {
          PointStep step = {.xx = Control::stress(-cell), .yy = Control::strain(0.01 * axial)};
          if (triaxial) {
            step.zz = Control::stress(-cell);
          }
          point.apply(step);
        }
        const double expected = (triaxial ? std::numbers::sqrt3 : 2.0) * s_u;
        EXPECT_NEAR(std::abs(point.stress().yy - point.stress().xx), expected, 1e-6 * expected);
      }
    }
  }
}

/// tau_r + 2 F((gamma - gamma_r)/2) after every reversal, F the monotonic curve; an inner loop closes and the
/// outer one goes on as if it had not been.
TEST(MultiYieldClay, ObeysMasingInCyclicShear) {
  const MultiYieldClay clay = multi_yield_clay(elastic, s_u);
  PointTest point(clay, {-80e3, -80e3, -80e3, 0.0});
  const double amplitude = 5e-3;
  shear_to(point, amplitude, 100);
  const double top = monotonic_stress(clay, amplitude);
  EXPECT_NEAR(point.stress().xy, top, 1e-10 * s_u);
  const auto falling = [&](double strain) {
    return top - 2.0 * monotonic_stress(clay, 0.5 * (amplitude - strain));
  };
  for (const double strain : {4e-3, 1e-3, -1e-3}) {
    shear_to(point, strain, 20);
    EXPECT_NEAR(point.stress().xy, falling(strain), 1e-10 * s_u);
  }
  const double turn = falling(-1e-3);
  shear_to(point, 5e-4, 20);
  EXPECT_NEAR(point.stress().xy, turn + 2.0 * monotonic_stress(clay, 0.5 * 1.5e-3), 1e-10 * s_u);
  for (const double strain : {-2e-3, -amplitude}) {
    shear_to(point, strain, 40);
    EXPECT_NEAR(point.stress().xy, falling(strain), 1e-10 * s_u);
  }
  shear_to(point, amplitude, 100);
  EXPECT_NEAR(point.stress().xy, top, 1e-10 * s_u);
}

/// A point started under shear is one that was brought there by monotonic loading.
TEST(MultiYieldClay, InitialShearStressIsPartOfTheStrength) {
  const MultiYieldClay clay = multi_yield_clay(elastic, s_u);
  PointTest loaded(clay, {-80e3, -80e3, -80e3, 0.0});
  shear_to(loaded, 2e-3, 50);
  PointTest started(clay, {-80e3, -80e3, -80e3, loaded.stress().xy});
  for (std::size_t k = 0; k < loaded.state().size(); ++k) {
    EXPECT_NEAR(started.state()[k], loaded.state()[k], 1e-9 * s_u);
  }
  for (const double change : {-3e-3, 1e-3, 0.2}) {
    loaded.apply(shear(change));
    started.apply(shear(change));
    EXPECT_NEAR(started.stress().xy, loaded.stress().xy, 1e-9 * s_u);
  }
  EXPECT_NEAR(started.stress().xy, s_u, 1e-9 * s_u);
}

TEST(MultiYieldClay, AnInitialStressBeyondTheStrengthComesBackToIt) {
  const MultiYieldClay clay = multi_yield_clay(elastic, s_u);
  const PointTest point(clay, {-100e3, -400e3, -100e3, 90e3});
  const PointStress& s = point.stress();
  const double mean = (s.xx + s.yy + s.zz) / 3.0;
  EXPECT_NEAR(mean, -200e3, 1e-6);
  const double xx = s.xx - mean;
  const double yy = s.yy - mean;
  EXPECT_NEAR(std::sqrt(xx * xx + yy * yy + xx * yy + s.xy * s.xy), s_u, 1e-10 * s_u);
  EXPECT_NEAR(s.xy / xx, 90.0 / 100.0, 1e-12);
}

/// Elements and stress stay one: s_xy is the sum over the state.
TEST(MultiYieldClay, StressIsTheSumOfItsElements) {
  const MultiYieldClay clay = multi_yield_clay(elastic, s_u);
  PointTest point(clay, {-90e3, -150e3, -90e3, 10e3});
  for (const double change : {2e-3, -5e-3, 1e-2, -0.3, 0.1}) {
    PointStep step = shear(change);
    step.xx = Control::strain(0.3 * change);
    step.yy = Control::strain(-0.3 * change);
    step.rotation = 0.2;
    point.apply(step);
  }
  double xy = 0.0;
  double xx = 0.0;
  for (std::size_t first = 0; first < point.state().size(); first += 3 * iwan_group) {
    for (std::size_t k = 0; k < iwan_group; ++k) {
      xx += point.state()[first + k];
      xy += point.state()[first + 2 * iwan_group + k];
    }
  }
  const PointStress& s = point.stress();
  EXPECT_NEAR(s.xy, xy, 1e-9 * s_u);
  EXPECT_NEAR(s.xx - (s.xx + s.yy + s.zz) / 3.0, xx, 1e-8 * s_u);
}

SoilCurves table() {
  return {{1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3}, {1.0, 1.0, 0.85, 0.66, 0.38, 0.19}, {0, 0, 0, 0, 0, 0}};
}

TEST(MultiYieldClay, PassesThroughAModulusReductionCurve) {
  const SoilCurves curves = table();
  const MultiYieldClay clay = multi_yield_clay(elastic, s_u, curves);
  EXPECT_EQ(clay.elements.size() % iwan_group, 0U);
  PointTest point(clay, {});
  for (std::size_t k = 0; k < curves.strain.size(); ++k) {
    shear_to(point, curves.strain[k], 3);
    EXPECT_NEAR(point.stress().xy / (30e6 * curves.strain[k]), curves.modulus_ratio[k], 1e-9);
  }
  shear_to(point, 0.1, 3);
  EXPECT_NEAR(point.stress().xy, s_u, 1e-9 * s_u);
}

TEST(MultiYieldClay, StopsACurveAtTheStrength) {
  const MultiYieldClay clay = multi_yield_clay(elastic, 10e3, table());
  for (const double strain : {3e-4, 1e-3, 0.1}) { // the table gives 5.9 and 11.4 kPa
    EXPECT_NEAR(monotonic_stress(clay, strain), strain < 5e-4 ? 30e6 * 3e-4 * 0.66 : 10e3, 1e-6);
  }
}

TEST(MultiYieldClay, RefusesCurvesThatAreNotConcave) {
  SoilCurves curves = table();
  curves.modulus_ratio[4] = 0.65;
  try {
    multi_yield_clay(elastic, s_u, curves);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("modulus reduction curve: from strain 0.0003 to 0.001"));
  }
  EXPECT_THROW(multi_yield_clay(elastic, 100e3, table(), 2e-3), std::invalid_argument);
}

TEST(MultiYieldClay, RefusesWhatIsNotPhysical) {
  EXPECT_THROW(multi_yield_clay(elastic, 0.0), std::invalid_argument);
  EXPECT_THROW(multi_yield_clay(elastic, std::nan("")), std::invalid_argument);
  EXPECT_THROW(multi_yield_clay(elastic, 3.1e6), std::invalid_argument); // 3 MPa at 10 % even elastically
  EXPECT_THROW(multi_yield_clay(elastic, s_u, {.count = 10}), std::invalid_argument);
  MultiYieldClay clay = multi_yield_clay(elastic, s_u);
  EXPECT_NO_THROW(validate(clay));
  clay.undrained_strength = 50e3;
  EXPECT_THROW(validate(clay), std::invalid_argument);
}

} // namespace
} // namespace tremolo::materials
