// Soil tests on linear elastic soil against closed forms, E = 40 MPa, nu = 0.28.

#include "materials/soiltest/cyclic/modulus_curve.hpp"
#include "materials/soiltest/soil_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::soiltest {
namespace {

const materials::Elasticity elastic = {1700.0, 40e6, 0.28};
const materials::Law law = materials::LinearElastic{elastic};
constexpr double strain = 1e-3;

SoilTest monotonic(Kind kind, Drainage drainage) {
  SoilTest test;
  test.kind = kind;
  test.drainage = drainage;
  test.initial.vertical_stress = 100e3;
  test.loading = Monotonic{strain};
  test.strain_increment = 2e-5;
  return test;
}

SoilTest undrained(Kind kind, double pore_stiffness) {
  SoilTest test = monotonic(kind, Drainage::undrained);
  test.pore_stiffness = pore_stiffness;
  return test;
}

/// Change of a column from the first to the last row.
double change(const Result& result, std::string_view column) {
  return result.history.column(column).back() - result.history.column(column).front();
}

TEST(ElasticSoilTest, OedometerHasTheConstrainedModulus) {
  const Result result = run(law, monotonic(Kind::oedometer, Drainage::drained));
  EXPECT_NEAR(change(result, "sig_yy") / (-strain * elastic.p_modulus()), 1.0, 1e-10);
  EXPECT_NEAR(change(result, "sig_xx") / change(result, "sig_yy"), elastic.rest_coefficient(), 1e-10);
}

TEST(ElasticSoilTest, IsotropicCompressionHasTheBulkModulus) {
  const Result result = run(law, monotonic(Kind::isotropic_compression, Drainage::drained));
  EXPECT_NEAR(change(result, "sig_zz") / (-3.0 * strain * elastic.bulk_modulus()), 1.0, 1e-10);
  EXPECT_NEAR(change(result, "p_inplane") / (3.0 * strain * elastic.bulk_modulus()), 1.0, 1e-10);
  const Result plane =
      run(materials::MasingShear{elastic, 1e-3}, monotonic(Kind::isotropic_compression, Drainage::drained));
  const double in_plane = elastic.bulk_modulus() + elastic.shear_modulus() / 3.0;
  EXPECT_NEAR(change(plane, "p_inplane") / (2.0 * strain * in_plane), 1.0, 1e-10);
}

TEST(ElasticSoilTest, TriaxialCompressionAndExtensionGiveYoungAndPoisson) {
  for (const Kind kind : {Kind::triaxial_compression, Kind::triaxial_extension}) {
    const Result result = run(law, monotonic(kind, Drainage::drained));
    const double axial = kind == Kind::triaxial_compression ? strain : -strain;
    EXPECT_NEAR(change(result, "sig_yy") / (-axial * elastic.young), 1.0, 1e-9);
    EXPECT_NEAR(change(result, "eps_xx") / (axial * elastic.poisson), 1.0, 1e-9);
    EXPECT_NEAR(change(result, "eps_zz") / (axial * elastic.poisson), 1.0, 1e-9);
  }
}

TEST(ElasticSoilTest, PlaneStrainCompressionIsStiffer) {
  const Result result = run(law, monotonic(Kind::plane_strain_compression, Drainage::drained));
  const double plane = elastic.young / (1.0 - elastic.poisson * elastic.poisson);
  EXPECT_NEAR(change(result, "sig_yy") / (-strain * plane), 1.0, 1e-9);
}

TEST(ElasticSoilTest, SimpleShearMakesNoPorePressure) {
  for (const SoilTest& test : {monotonic(Kind::direct_simple_shear, Drainage::constant_volume),
                               undrained(Kind::direct_simple_shear, 5e9)}) {
    const Result result = run(law, test);
    EXPECT_NEAR(change(result, "sig_xy"), strain * elastic.shear_modulus(), 1e-6);
    EXPECT_NEAR(result.largest_pore_pressure_ratio, 0.0, 1e-9);
  }
}

/// G = E/(2 (1 + nu)) whatever the test: tau and gamma belong together.
TEST(ElasticSoilTest, LoopsHaveTheShearModulusInEveryTest) {
  const double poisson = elastic.poisson;
  const std::vector<std::pair<Kind, double>> gamma_of_axial = {
      {Kind::direct_simple_shear, 1.0},
      {Kind::triaxial_compression, 1.0 + poisson},
      {Kind::triaxial_extension, 1.0 + poisson},
      {Kind::plane_strain_compression, 1.0 / (1.0 - poisson)},
      {Kind::plane_strain_extension, 1.0 / (1.0 - poisson)}};
  for (const auto& [kind, factor] : gamma_of_axial) {
    const std::vector<double> amplitude = {1e-4};
    const ModulusPoint point =
        modulus_curve(law, monotonic(kind, Drainage::drained), amplitude, 2).points.front();
    EXPECT_NEAR(point.modulus / elastic.shear_modulus(), 1.0, 1e-6) << name(kind);
    EXPECT_NEAR(point.modulus_ratio, 1.0, 1e-6) << name(kind);
    EXPECT_NEAR(point.shear_strain, factor * 1e-4, 1e-10) << name(kind);
    EXPECT_NEAR(point.damping, 0.0, 1e-6) << name(kind);
  }
}

/// asin((s_1 - s_3)/(s_1 + s_3)) at the end of compression from 100 kPa with q = E eps_a.
TEST(ElasticSoilTest, MobilisedAngleIsThatOfTheLastStress) {
  const Result result = run(law, monotonic(Kind::triaxial_compression, Drainage::drained));
  const double deviator = elastic.young * strain;
  EXPECT_NEAR(result.mobilised_angle, std::asin(deviator / (200e3 + deviator)), 1e-9);
  SoilTest pulled = monotonic(Kind::triaxial_extension, Drainage::drained);
  pulled.loading = Monotonic{5e-3}; // 200 kPa of unloading: the vertical stress is a tension
  EXPECT_EQ(run(law, pulled).mobilised_angle, 0.5 * std::numbers::pi);
}

/// Skempton (1954): du = B (d_sigma_3 + A (d_sigma_1 - d_sigma_3)), B = 1/(1 + n K/K_w), A = 1/3.
TEST(ElasticSoilTest, UndrainedTriaxialGivesSkemptonsCoefficients) {
  for (const double water : {20e6, 500e6, 5e9}) {
    const double b = water / (elastic.bulk_modulus() + water);
    const Result cell = run(law, undrained(Kind::isotropic_compression, water));
    const double u = change(cell, "u");
    EXPECT_NEAR(u / (u + change(cell, "p_inplane")), b, 1e-9); // over the total pressure
    const Result axial = run(law, undrained(Kind::triaxial_compression, water));
    const double deviator = change(axial, "sig_xx") - change(axial, "sig_yy");
    EXPECT_NEAR(change(axial, "u") / (b * deviator), 1.0 / 3.0, 1e-7);
    EXPECT_NEAR(change(axial, "sig_xx") - change(axial, "u"), 0.0, 1e-5) << "total cell pressure";
  }
}

/// Plane strain: eps_v = (1 + nu)(1 - 2 nu)/E (d_sigma - 2u) and u = K_w/n eps_v.
TEST(ElasticSoilTest, UndrainedPlaneStrainSharesTheLoad) {
  const double water = 100e6;
  const Result result = run(law, undrained(Kind::plane_strain_compression, water));
  const double a = water * (1.0 + elastic.poisson) * (1.0 - 2.0 * elastic.poisson) / elastic.young;
  const double total = change(result, "u") - change(result, "sig_yy");
  EXPECT_NEAR(change(result, "u") / total, a / (1.0 + 2.0 * a), 1e-8);
}

/// At constant volume the cell pressure is what rises: u = d_q/3 in triaxial, d_q/2 in plane strain
/// compression.
TEST(ElasticSoilTest, ConstantVolumeIsTheLimitOfStiffWater) {
  for (const Kind kind : {Kind::triaxial_compression, Kind::plane_strain_extension}) {
    const Result constant = run(law, monotonic(kind, Drainage::constant_volume));
    const Result stiff = run(law, undrained(kind, 1e13));
    const double deviator = change(constant, "sig_xx") - change(constant, "sig_yy");
    EXPECT_NEAR(change(constant, "u") / deviator, kind == Kind::triaxial_compression ? 1.0 / 3.0 : 0.5, 1e-9);
    EXPECT_NEAR(change(stiff, "u") / change(constant, "u"), 1.0, 1e-4);
    EXPECT_NEAR(change(stiff, "sig_yy") / change(constant, "sig_yy"), 1.0, 1e-4);
  }
}

} // namespace
} // namespace tremolo::soiltest
