// Apex and tension cut-off: where the surface ends in tension.

#include "soils.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo::materials::test {
namespace {

PointTest expanded(const MohrCoulomb& soil, const PointStep& step, int steps) {
  PointTest point(soil, {-10.0 * kPa, -10.0 * kPa, -10.0 * kPa, 0.0});
  for (int n = 0; n < steps; ++n) {
    point.apply(step);
  }
  return point;
}

constexpr double expansion = 1e-4;

TEST(Apex, IsotropicTensionEndsAtCohesionTimesCotangent) {
  for (const double friction : {20.0, 45.0}) {
    const PointTest point = expanded(perfect_soil(friction, 0.0, 4.0 * kPa),
                                     {Control::strain(expansion), Control::strain(expansion)}, 50);
    const double apex = 4.0 * kPa / std::tan(friction * degree);
    EXPECT_NEAR(point.stress().xx, apex, 1e-9 * apex);
    EXPECT_NEAR(point.stress().yy, apex, 1e-9 * apex);
    EXPECT_NEAR(point.stress().zz, apex, 1e-9 * apex);
  }
}

TEST(Apex, MovesToTheOriginAsCohesionVanishes) {
  const PointTest point = expanded(slope_soil(), {Control::strain(2e-3), Control::strain(1e-3)}, 5000);
  EXPECT_NEAR(point.stress().xx, 0.0, 1e-9);
  EXPECT_NEAR(point.stress().zz, 0.0, 1e-9);
  EXPECT_GT(point.state()[equivalent_plastic_strain], 1.0);
}

TEST(Apex, CohesionlessSoilOpensWithoutStressAndCarriesLoadWhenClosed) {
  MohrCoulomb sand = residual_soil();
  PointTest point = expanded(sand, {Control::strain(expansion), Control::strain(expansion)}, 20);
  EXPECT_EQ(point.stress().xx, 0.0);
  EXPECT_EQ(point.stress().zz, 0.0);
  point.apply({Control::strain(-1e-4), Control::strain(-1e-4)});
  const double pressure = 2.0 * (sand.elastic.lame() + sand.elastic.shear_modulus()) * 1e-4;
  EXPECT_LT(point.stress().xx, -0.5 * pressure);
}

TEST(Cutoff, LimitsUniaxialTension) {
  MohrCoulomb soil = perfect_soil(30.0, 0.0, 10.0 * kPa);
  soil.tension_cutoff = 3.0 * kPa;
  const PointTest point = expanded(soil, {Control::stress(-10.0 * kPa), Control::strain(expansion)}, 20);
  EXPECT_NEAR(point.stress().yy, 3.0 * kPa, 1e-9 * kPa);
  EXPECT_NEAR(point.stress().xx, -10.0 * kPa, 1e-6 * kPa);
}

/// Equal in-plane expansion: both in-plane stresses rise by 13 kPa to the cut-off, s_zz by 2 nu times that,
/// and stays.
TEST(Cutoff, HoldsTwoPrincipalStresses) {
  MohrCoulomb soil = perfect_soil(30.0, 0.0, 10.0 * kPa);
  soil.tension_cutoff = 3.0 * kPa;
  const PointTest point = expanded(soil, {Control::strain(expansion), Control::strain(expansion)}, 50);
  EXPECT_NEAR(point.stress().xx, 3.0 * kPa, 1e-9 * kPa);
  EXPECT_NEAR(point.stress().yy, 3.0 * kPa, 1e-9 * kPa);
  EXPECT_NEAR(point.stress().zz, (-10.0 + 2.0 * 0.28 * 13.0) * kPa, 1e-9 * kPa);
}

/// Pulled apart in plane from a stress close to the cut-off: all three principal stresses end at it.
TEST(Cutoff, HoldsThreePrincipalStresses) {
  MohrCoulomb soil = perfect_soil(30.0, 0.0, 10.0 * kPa);
  soil.tension_cutoff = 3.0 * kPa;
  PointTest point(soil, {2.0 * kPa, 2.0 * kPa, 2.5 * kPa, 0.0});
  point.apply({Control::strain(expansion), Control::strain(0.9 * expansion)});
  EXPECT_NEAR(point.stress().xx, 3.0 * kPa, 1e-9 * kPa);
  EXPECT_NEAR(point.stress().yy, 3.0 * kPa, 1e-9 * kPa);
  EXPECT_NEAR(point.stress().zz, 3.0 * kPa, 1e-9 * kPa);
}

/// Associated flow on the cut-off alone: one step from a trial with s1 > t moves the stress along D (1, 0,
/// 0).
TEST(Cutoff, FlowIsAssociated) {
  MohrCoulomb soil = perfect_soil(30.0, 0.0, 50.0 * kPa);
  soil.tension_cutoff = 5.0 * kPa;
  PointTest point(soil, {-5.0 * kPa, 0.0, -5.0 * kPa, 0.0});
  const double strain = 4e-4;
  point.apply({Control::strain(0.0), Control::strain(strain)});
  const double lame = soil.elastic.lame();
  const double modulus = soil.elastic.p_modulus();
  const double multiplier = (modulus * strain - 5.0 * kPa) / modulus;
  EXPECT_NEAR(point.stress().yy, 5.0 * kPa, 1e-9 * kPa);
  EXPECT_NEAR(point.stress().xx, -5.0 * kPa + lame * (strain - multiplier), 1e-9 * kPa);
  EXPECT_NEAR(point.stress().zz, -5.0 * kPa + lame * (strain - multiplier), 1e-9 * kPa);
}

/// Cut-off and shear plane together: s1 = t and f13 = 0 give both in-plane stresses.
TEST(Cutoff, MeetsTheShearPlane) {
  MohrCoulomb soil = perfect_soil(30.0, 0.0, 10.0 * kPa);
  soil.tension_cutoff = 3.0 * kPa;
  const PointTest point = expanded(soil, {Control::strain(-3e-4), Control::strain(5e-4)}, 50);
  const double sine = std::sin(30.0 * degree);
  const double s3 = (3.0 * kPa * (1.0 + sine) - 20.0 * kPa * std::cos(30.0 * degree)) / (1.0 - sine);
  EXPECT_NEAR(point.stress().yy, 3.0 * kPa, 1e-9 * kPa);
  EXPECT_NEAR(point.stress().xx, s3, 1e-9 * kPa);
}

TEST(Cutoff, NeverLiesAboveTheApex) {
  MohrCoulomb soil = perfect_soil(45.0, 0.0, 4.0 * kPa);
  soil.tension_cutoff = 100.0 * kPa;
  const PointTest point = expanded(soil, {Control::strain(expansion), Control::strain(expansion)}, 50);
  EXPECT_NEAR(point.stress().xx, 4.0 * kPa, 1e-9 * kPa);
}

} // namespace
} // namespace tremolo::materials::test
