// Two paths on which the softening law has an exact solution, with plastic multiplier l as parameter.
//
// Drained plane-strain compression without dilation from an isotropic stress s3, while s2 stays intermediate:
//
//     e = 2/sqrt(3) l,   s1 = N(phi(e)) s3 + 2 c(e) sqrt(N(phi(e))),   eps1 = (1 - nu^2)/E (s1 - s3) + l.
//
// Simple shear at constant volume without dilation from s_xx = s_yy = -s, s_zz between the others:
//
//     e = 2/sqrt(3) l,   tau = s sin(phi(e)) + c(e) cos(phi(e)),   gamma = tau/G + 2 l.

#include "soils.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tremolo::materials::test {
namespace {

struct CurvePoint {
  double strain = 0.0;
  double stress = 0.0; // Pa, compression positive
};

CurvePoint exact(const MohrCoulomb& soil, double lateral, double multiplier) {
  const double e = 2.0 / std::sqrt(3.0) * multiplier;
  const double decay = std::exp(-soil.softening * e);
  const double c = soil.cohesion_residual + (soil.cohesion_peak - soil.cohesion_residual) * decay;
  const double phi = soil.friction_residual + (soil.friction_peak - soil.friction_residual) * decay;
  const double n = flow_value(phi);
  const double s1 = n * lateral + 2.0 * c * std::sqrt(n);
  const double nu = soil.elastic.poisson;
  return {(1.0 - nu * nu) / soil.elastic.young * (s1 - lateral) + multiplier, s1};
}

TEST(SofteningCurve, ExactSolutionAgreesWithItsTable) {
  constexpr std::array<std::array<double, 2>, 6> table = {{{0.00601, 310.735},
                                                           {0.01509, 270.995},
                                                           {0.02917, 230.91},
                                                           {0.05328, 192.182},
                                                           {0.10251, 158.753},
                                                           {0.15223, 146.654}}};
  constexpr std::array<double, 6> multipliers = {0.0, 0.01, 0.025, 0.05, 0.1, 0.15};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const CurvePoint point = exact(slope_soil(), 50.0 * kPa, multipliers[i]);
    EXPECT_NEAR(point.strain, table[i][0], 1e-5);
    EXPECT_NEAR(point.stress, table[i][1] * kPa, 1.0);
  }
}

/// Drives the law to exactly the strains of the exact solution, in steps of about `increment`.
void expect_exact_curve(const MohrCoulomb& soil, double lateral, double increment) {
  PointTest point(soil, {-lateral, -lateral, -lateral, 0.0});
  for (double multiplier = 0.0; multiplier <= 0.2; multiplier += 0.02) {
    const CurvePoint target = exact(soil, lateral, multiplier);
    const double missing = target.strain + point.strain().yy;
    const int steps = static_cast<int>(std::ceil(missing / increment));
    for (int n = 0; n < steps; ++n) {
      point.apply({Control::stress(-lateral), Control::strain(-missing / steps)});
    }
    EXPECT_NEAR(-point.stress().yy, target.stress, 1e-6 * target.stress) << "strain " << target.strain;
    EXPECT_NEAR(point.state()[equivalent_plastic_strain], 2.0 / std::sqrt(3.0) * multiplier, 1e-6);
  }
}

TEST(SofteningCurve, IsFollowedInSmallAndLargeSteps) {
  expect_exact_curve(slope_soil(), 50.0 * kPa, 1e-4);
  expect_exact_curve(slope_soil(), 50.0 * kPa, 2e-3);
  expect_exact_curve(slope_soil(), 10.0 * kPa, 5e-4);
}

CurvePoint exact_undrained(const MohrCoulomb& soil, double mean, double multiplier) {
  const double e = 2.0 / std::sqrt(3.0) * multiplier;
  const double decay = std::exp(-soil.softening * e);
  const double c = soil.cohesion_residual + (soil.cohesion_peak - soil.cohesion_residual) * decay;
  const double phi = soil.friction_residual + (soil.friction_peak - soil.friction_residual) * decay;
  const double stress = mean * std::sin(phi) + c * std::cos(phi);
  return {stress / soil.elastic.shear_modulus() + 2.0 * multiplier, stress};
}

/// Peak 55.86 kPa, at first yield.
TEST(SofteningCurve, IsFollowedAtConstantVolume) {
  const MohrCoulomb soil = slope_soil();
  EXPECT_NEAR(exact_undrained(soil, 75.0 * kPa, 0.0).stress, 55.86 * kPa, 5.0);
  for (const double increment : {1e-5, 1e-4, 2e-3}) {
    PointTest point(soil, {-75.0 * kPa, -75.0 * kPa, -50.0 * kPa, 0.0});
    for (double multiplier = 0.0; multiplier <= 0.1; multiplier += 0.01) {
      const CurvePoint target = exact_undrained(soil, 75.0 * kPa, multiplier);
      const double missing = target.strain - point.strain().xy;
      const int steps = static_cast<int>(std::ceil(missing / increment));
      for (int n = 0; n < steps; ++n) {
        point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(missing / steps)});
      }
      EXPECT_NEAR(point.stress().xy, target.stress, 1e-6 * target.stress);
    }
  }
}

TEST(SofteningCurve, WithoutSofteningStaysAtThePeak) {
  const MohrCoulomb soil = without_softening(slope_soil());
  PointTest point(soil, {-50.0 * kPa, -50.0 * kPa, -50.0 * kPa, 0.0});
  for (int n = 0; n < 100; ++n) {
    point.apply({Control::stress(-50.0 * kPa), Control::strain(-1e-3)});
  }
  EXPECT_NEAR(-point.stress().yy, exact(slope_soil(), 50.0 * kPa, 0.0).stress, 1e-6 * kPa);
  EXPECT_GT(point.state()[equivalent_plastic_strain], 0.09);
}

/// A shear band of thickness h slips by 2 l h (psi = 0, engineering shear strain 2 l): with the regularised
/// eta the strength after a given slip is the same for every h.
TEST(SofteningCurve, RegularisationKeepsStrengthAgainstSlip) {
  const double reference = 0.5;
  const double slip = 0.02;
  const double expected = exact(slope_soil(), 50.0 * kPa, slip / (2.0 * reference)).stress;
  for (const double h : {0.125, 0.25, 1.0}) {
    const MohrCoulomb soil = for_cell_size(slope_soil(), h, reference);
    EXPECT_NEAR(exact(soil, 50.0 * kPa, slip / (2.0 * h)).stress, expected, 1e-9 * expected);
    EXPECT_DOUBLE_EQ(soil.softening, 15.0 * h / reference);
  }
}

} // namespace
} // namespace tremolo::materials::test
