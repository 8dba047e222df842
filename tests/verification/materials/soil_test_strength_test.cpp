// Soil tests on Mohr-Coulomb soil against the closed forms of its strength, and along reference curves.

#include "soils.hpp"
#include "tests/support/reference_curve.hpp"

#include "materials/soiltest/path/path_table.hpp"
#include "materials/soiltest/soil_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace tremolo::soiltest {
namespace {

using materials::MohrCoulomb;
using materials::test::degree;
using materials::test::flow_value;
using materials::test::kPa;
using materials::test::perfect_soil;
using materials::test::residual_soil;
using materials::test::slope_soil;

SoilTest drained(Kind kind, double strain) {
  SoilTest test;
  test.kind = kind;
  test.drainage = Drainage::drained;
  test.initial = {100.0 * kPa, 1.0};
  test.loading = Monotonic{strain};
  test.strain_increment = 2e-4;
  return test;
}

double last(const Result& result, std::string_view column) {
  return result.history.column(column).back();
}

/// sigma_1 = N sigma_3 + 2 c sqrt(N), whatever the intermediate stress.
TEST(StrengthBySoilTest, OfCompressionAndExtension) {
  for (const MohrCoulomb& soil : {perfect_soil(30.0, 0.0, 5.0 * kPa), perfect_soil(40.0, 10.0, 2.0 * kPa)}) {
    const double flow = flow_value(soil.friction_peak);
    const double cohesion = 2.0 * soil.cohesion_peak * std::sqrt(flow);
    for (const Kind kind : {Kind::triaxial_compression, Kind::plane_strain_compression}) {
      EXPECT_NEAR(-last(run(soil, drained(kind, 0.05)), "sig_yy"), flow * 100.0 * kPa + cohesion, 1.0)
          << name(kind);
    }
    for (const Kind kind : {Kind::triaxial_extension, Kind::plane_strain_extension}) {
      EXPECT_NEAR(-last(run(soil, drained(kind, 0.05)), "sig_yy"), (100.0 * kPa - cohesion) / flow, 1.0)
          << name(kind);
    }
  }
}

/// Davis (1968): tau = (sv sin(phi) cos(psi) + c cos(phi) cos(psi)) / (1 - sin(phi) sin(psi)).
TEST(StrengthBySoilTest, OfSimpleShear) {
  SoilTest test = drained(Kind::direct_simple_shear, 0.2);
  test.initial.k0 = 0.5;
  for (const double dilation : {0.0, 10.0, 30.0}) {
    const MohrCoulomb soil = perfect_soil(30.0, dilation, 10.0);
    const double sine = std::sin(30.0 * degree);
    const double davis = (100.0 * kPa * sine + 10.0 * std::cos(30.0 * degree)) * std::cos(dilation * degree) /
                         (1.0 - sine * std::sin(dilation * degree));
    EXPECT_NEAR(run(soil, test).peak_shear_stress / davis, 1.0, 2e-4) << dilation;
  }
  EXPECT_NEAR(run(residual_soil(), test).peak_shear_stress, 100.0 * kPa * std::sin(28.0 * degree), 0.1 * kPa);
}

/// Constant volume, psi = 0, K0 = 1/2: the mean in-plane stress stays, tau = 75 sin(phi) + c cos(phi).
TEST(StrengthBySoilTest, OfSimpleShearAtConstantVolume) {
  SoilTest test = drained(Kind::direct_simple_shear, 0.2);
  test.drainage = Drainage::constant_volume;
  test.initial.k0 = 0.5;
  const Result result = run(perfect_soil(45.0, 0.0, 4.0 * kPa), test);
  EXPECT_NEAR(result.peak_shear_stress, (75.0 * kPa + 4.0 * kPa) * std::sqrt(0.5), 0.02 * kPa);
  EXPECT_NEAR(last(result, "u"), 100.0 * kPa - 75.0 * kPa, 0.02 * kPa); // principal axes at 45 degrees
}

/// Dilating soil: pore water of growing stiffness comes to the same effective stress as constant volume.
TEST(StrengthBySoilTest, StiffWaterIsConstantVolume) {
  SoilTest test = drained(Kind::direct_simple_shear, 0.01);
  test.initial.k0 = 0.5;
  test.drainage = Drainage::constant_volume;
  const MohrCoulomb soil = perfect_soil(30.0, 5.0, 1.0 * kPa);
  const Result constant = run(soil, test);
  test.drainage = Drainage::undrained;
  double tau_before = 1.0;
  double u_before = 1.0;
  for (const double water : {1e9, 1e10, 1e11}) {
    test.pore_stiffness = water;
    const Result stiff = run(soil, test);
    const double tau_error = std::abs(last(stiff, "sig_xy") / last(constant, "sig_xy") - 1.0);
    const double u_error = std::abs(last(stiff, "u") / last(constant, "u") - 1.0);
    EXPECT_LT(tau_error, 0.15 * tau_before); // first order in 1/K_w
    EXPECT_LT(u_error, 0.15 * u_before);
    tau_before = tau_error;
    u_before = u_error;
  }
  EXPECT_LT(u_before, 1e-4);
}

/// Follows a curve of an independent implementation (kPa) as a prescribed path, in some increments a row; the
/// largest difference of a stress, Pa.
double worst(const std::string& file, const MohrCoulomb& soil, const std::vector<std::string>& by_stress,
             const InitialState& initial, double increments, const std::string& stress) {
  std::ifstream table(testing::reference_folder() / "materials" / file);
  Path path = read_path(table, by_stress, kPa);
  for (PathRow& row : path.rows) {
    row.step *= increments;
  }
  SoilTest test;
  test.kind = Kind::path;
  test.drainage = Drainage::drained;
  test.initial = initial;
  test.loading = path;
  test.every = 1000000; // the rows of the file alone
  const Result result = run(soil, test);
  const std::vector<double> wanted = testing::ReferenceCurve(file).column(stress);
  double difference = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    difference = std::max(difference, std::abs(result.history.column(stress).at(i) - kPa * wanted[i]));
  }
  return difference;
}

TEST(StrengthBySoilTest, FollowsReferencePaths) {
  if (testing::ReferenceCurve("mc_seed_psc_d_s50.csv").empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  const InitialState at_rest = {100.0 * kPa, 0.5};
  EXPECT_LT(worst("mc_perfect30psi10_dss_d_s100_k05.csv", perfect_soil(30.0, 10.0, 10.0), {"sig_yy"}, at_rest,
                  10.0, "sig_xy"),
            0.05 * kPa);
  EXPECT_LT(worst("mc_seed_dss_d_s100_k05.csv", slope_soil(), {"sig_yy"}, at_rest, 4.0, "sig_xy"), 0.1 * kPa);
  EXPECT_LT(worst("mc_seed_psc_d_s50.csv", slope_soil(), {"sig_xx"}, {50.0 * kPa, 1.0}, 1.0, "sig_yy"),
            2e-3 * 310.7 * kPa);
  EXPECT_LT(worst("mc_seed_path_apex_s10.csv", slope_soil(), {}, {10.0 * kPa, 1.0}, 1.0, "sig_yy"),
            0.1 * kPa);
}

} // namespace
} // namespace tremolo::soiltest
