// Drucker-Prager strengths against closed forms in triaxial compression, triaxial extension and plane strain,
// for the cones matched to each, and against Mohr-Coulomb where they are matched. With cell pressure s and
// deviator D of the principal stresses (compression positive):
//
//     triaxial compression   D = (eta s + xi c)/(1/sqrt(3) - eta/3)
//     triaxial extension     D = (eta s + xi c)/(1/sqrt(3) + eta/3)
//     plane strain           D/2 = k (eta s + xi c)/(1 - k eta),   k = sqrt(1 - eta'^2/3)/(1 - eta eta'/3)
//
// In plane strain the out-of-plane plastic strain rate vanishes at the limit, s_zz = -2/3 eta' q, which gives
// k.

#include "soils.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace tremolo::materials::test {
namespace {

using enum ConeMatch;
constexpr std::array matches = {triaxial_compression, triaxial_extension, plane_strain};
constexpr double cell = 100.0 * kPa;

DruckerPrager soil(ConeMatch match, double friction_deg, double dilation_deg, double cohesion) {
  return {slope_soil().elastic, cohesion, friction_deg * degree, dilation_deg * degree, match};
}

/// Principal stress difference under a given cell pressure by the closed forms above, Pa.
double deviator(const DruckerPrager& law, ConeMatch condition) {
  const Cone c = cone(law);
  const double push = c.slope * cell + c.strength;
  const double in_plane =
      std::sqrt(1.0 - c.dilatancy * c.dilatancy / 3.0) / (1.0 - c.slope * c.dilatancy / 3.0);
  switch (condition) {
  case triaxial_compression:
    return push / (1.0 / std::numbers::sqrt3 - c.slope / 3.0);
  case triaxial_extension:
    return push / (1.0 / std::numbers::sqrt3 + c.slope / 3.0);
  default:
    return 2.0 * in_plane * push / (1.0 - in_plane * c.slope);
  }
}

/// The same from Mohr-Coulomb: N s + 2 c sqrt(N) in compression, s/N - 2 c/sqrt(N) in extension.
double mohr_coulomb_deviator(const DruckerPrager& law, ConeMatch condition) {
  const double n = flow_value(law.friction);
  return condition == triaxial_extension ? cell - (cell / n - 2.0 * law.cohesion / std::sqrt(n))
                                         : n * cell + 2.0 * law.cohesion * std::sqrt(n) - cell;
}

/// Largest minus smallest principal stress after axial strain along y under cell pressure.
double tested_deviator(const Law& law, ConeMatch condition, double strain, int steps) {
  PointTest point(law, {-cell, -cell, -cell, 0.0});
  const double sign = condition == triaxial_extension ? 1.0 : -1.0;
  for (int n = 0; n < steps; ++n) {
    PointStep step = {.xx = Control::stress(-cell), .yy = Control::strain(sign * strain / steps)};
    if (condition != plane_strain) {
      step.zz = Control::stress(-cell);
    }
    point.apply(step);
  }
  return std::abs(point.stress().yy - point.stress().xx);
}

TEST(DruckerPrager, StrengthFollowsItsClosedFormsForEveryConeAndCondition) {
  for (const ConeMatch match : matches) {
    for (const double dilation : {0.0, 10.0, 30.0}) {
      const DruckerPrager law = soil(match, 30.0, dilation, 10.0 * kPa);
      for (const ConeMatch condition : matches) {
        const double expected = deviator(law, condition);
        EXPECT_NEAR(tested_deviator(law, condition, 0.3, 300), expected, 1e-7 * expected)
            << "cone " << static_cast<int>(match) << ", condition " << static_cast<int>(condition) << ", psi "
            << dilation;
      }
    }
  }
}

TEST(DruckerPrager, IsMohrCoulombInTheMatchedCondition) {
  for (const ConeMatch match : matches) {
    for (const double friction : {0.0, 20.0, 30.0, 40.0}) {
      for (const double dilation : {0.0, 0.5 * friction, friction}) {
        const DruckerPrager law = soil(match, friction, dilation, 10.0 * kPa);
        const double expected = mohr_coulomb_deviator(law, match);
        EXPECT_NEAR(deviator(law, match), expected, 1e-12 * expected);
      }
    }
    const DruckerPrager law = soil(match, 30.0, 10.0, 10.0 * kPa);
    const double expected = tested_deviator(perfect_soil(30.0, 10.0, 10.0 * kPa), match, 0.3, 300);
    EXPECT_NEAR(tested_deviator(law, match, 0.3, 300), expected, 1e-7 * expected);
  }
}

/// The constants as tables print them, phi = 30 degrees.
TEST(DruckerPrager, ConstantsForThirtyDegrees) {
  const double tangent = std::tan(30.0 * degree);
  EXPECT_NEAR(cone(soil(triaxial_compression, 30.0, 0.0, 1.0)).slope, 6.0 * 0.5 / (std::numbers::sqrt3 * 2.5),
              1e-15);
  EXPECT_NEAR(cone(soil(triaxial_extension, 30.0, 0.0, 1.0)).slope, 6.0 * 0.5 / (std::numbers::sqrt3 * 3.5),
              1e-15);
  EXPECT_NEAR(cone(soil(plane_strain, 30.0, 30.0, 1.0)).slope,
              3.0 * tangent / std::sqrt(9.0 + 12.0 * tangent * tangent), 1e-15);
  EXPECT_NEAR(cone(soil(plane_strain, 30.0, 30.0, 1.0)).strength,
              3.0 / std::sqrt(9.0 + 12.0 * tangent * tangent), 1e-15);
  EXPECT_NEAR(cone(soil(plane_strain, 30.0, 0.0, 1.0)).slope, 0.5, 1e-15);
}

/// Davis (1968): as Mohr-Coulomb, with the plane-strain cone.
TEST(DruckerPrager, SimpleShearLimitAndDilation) {
  for (const double dilation : {0.0, 10.0}) {
    const DruckerPrager law = soil(plane_strain, 30.0, dilation, 10.0 * kPa);
    const double sine = std::sin(law.friction);
    const double limit = (cell * sine + law.cohesion * std::cos(law.friction)) * std::cos(law.dilation) /
                         (1.0 - sine * std::sin(law.dilation));
    PointTest point(law, {-0.5 * cell, -cell, -0.5 * cell, 0.0});
    const auto shear = [&](int steps) {
      for (int n = 0; n < steps; ++n) {
        point.apply({Control::strain(0.0), Control::stress(-cell), Control::strain(1e-3)});
      }
    };
    shear(400);
    EXPECT_NEAR(point.stress().xy, limit, 1e-6 * limit);
    const PointStrain before = point.strain();
    shear(100);
    EXPECT_NEAR((point.strain().yy - before.yy) / (point.strain().xy - before.xy), std::tan(law.dilation),
                1e-5);
  }
}

TEST(DruckerPrager, TensionEndsAtTheApex) {
  for (const ConeMatch match : matches) {
    for (const double dilation : {0.0, 10.0}) {
      const DruckerPrager law = soil(match, 30.0, dilation, 4.0 * kPa);
      const double apex = 4.0 * kPa / std::tan(30.0 * degree);
      PointTest point(law, {-10.0 * kPa, -10.0 * kPa, -10.0 * kPa, 0.0});
      for (int n = 0; n < 100; ++n) {
        point.apply({Control::strain(1e-3), Control::strain(0.9e-3), Control::strain(1e-4)});
      }
      EXPECT_NEAR(point.stress().xx, apex, 1e-9 * apex);
      EXPECT_NEAR(point.stress().yy, apex, 1e-9 * apex);
      EXPECT_NEAR(point.stress().zz, apex, 1e-9 * apex);
      EXPECT_NEAR(point.stress().xy, 0.0, 1e-9 * apex);
      point.apply({Control::strain(-1e-4), Control::strain(-1e-4)});
      EXPECT_LT(point.stress().yy, apex - 1.0 * kPa);
    }
  }
}

/// Without friction it is von Mises: tau = xi c, plastic shear strain gamma_p = gamma - tau/G, and
/// e = gamma_p/sqrt(3); the plastic work is tau gamma_p.
TEST(DruckerPrager, PlasticStrainAndWorkInSimpleShear) {
  const DruckerPrager law = soil(plane_strain, 0.0, 0.0, 20.0 * kPa);
  const double shear = law.elastic.shear_modulus();
  PointTest point(law, {-50.0 * kPa, -50.0 * kPa, -50.0 * kPa, 0.0});
  const double yield = 20.0 * kPa / shear;
  for (const double change : {yield, 0.04, 0.06}) {
    point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(change)});
  }
  EXPECT_NEAR(point.stress().xy, 20.0 * kPa, 1e-6);
  EXPECT_NEAR(point.state()[0], 0.1 / std::numbers::sqrt3, 1e-12);
  EXPECT_NEAR(point.plastic_work(), 20.0 * kPa * 0.1, 1e-6);
}

TEST(DruckerPrager, RefusesWhatIsNotPhysical) {
  EXPECT_NO_THROW(validate(soil(plane_strain, 30.0, 10.0, 0.0)));
  EXPECT_THROW(validate(soil(plane_strain, 30.0, 31.0, 0.0)), std::invalid_argument);
  EXPECT_THROW(validate(soil(plane_strain, 90.0, 0.0, 0.0)), std::invalid_argument);
  EXPECT_THROW(validate(soil(plane_strain, 0.0, 0.0, 0.0)), std::invalid_argument);
  EXPECT_THROW(validate(soil(plane_strain, 30.0, 0.0, -1.0)), std::invalid_argument);
  EXPECT_THROW(validate(soil(plane_strain, std::nan(""), 0.0, 1.0)), std::invalid_argument);
}

} // namespace
} // namespace tremolo::materials::test
