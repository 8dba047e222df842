// Strain out of plane, as element tests with axial symmetry need it: Hooke's law in three dimensions, and the
// energy balance of the laws that dissipate.

#include "tests/support/single_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tremolo::materials::test {
namespace {

const Elasticity elastic = {1700.0, 40e6, 0.28};

MohrCoulomb friction_soil() {
  MohrCoulomb soil;
  soil.elastic = elastic;
  soil.cohesion_peak = soil.cohesion_residual = 5e3;
  soil.friction_peak = 0.6;
  soil.friction_residual = 0.5;
  soil.dilation_peak = 0.1;
  soil.softening = 15.0;
  return soil;
}

std::vector<Law> laws() {
  return {LinearElastic{elastic}, friction_soil(), iwan_shear(elastic, 5e-4, 1.0, 0.92)};
}

/// E and nu, from the strains: eps_yy = s/E, eps_xx = eps_zz = -nu s/E under a stress s along y alone.
TEST(OutOfPlane, UniaxialStressFollowsHooke) {
  SinglePoint point(LinearElastic{elastic}, {});
  const double axial = -1e-3;
  for (int n = 0; n < 10; ++n) {
    point.move({-0.028 * axial, 0.1 * axial, -0.028 * axial, 0.0});
  }
  EXPECT_NEAR(point.stress.yy, 40e6 * axial, 1e-8 * 40e3);
  EXPECT_NEAR(point.stress.xx, 0.0, 1e-8 * 40e3);
  EXPECT_NEAR(point.stress.zz, 0.0, 1e-8 * 40e3);
}

/// Isotropic strain: three times the bulk modulus, in every law while it is elastic or does not know
/// pressure.
TEST(OutOfPlane, IsotropicCompressionFollowsTheBulkModulus) {
  for (const Law& law : laws()) {
    SinglePoint point(law, {-10e3, -10e3, -10e3, 0.0});
    point.move({-1e-4, -1e-4, -1e-4, 0.0});
    const double expected = -10e3 - 3e-4 * elastic.bulk_modulus();
    EXPECT_NEAR(point.stress.xx, expected, 1e-6) << name(law);
    EXPECT_NEAR(point.stress.yy, expected, 1e-6) << name(law);
    EXPECT_NEAR(point.stress.zz, expected, 1e-6) << name(law);
  }
}

/// Zero strain out of plane is plane strain, bit by bit.
TEST(OutOfPlane, ZeroIsPlaneStrain) {
  for (const Law& law : laws()) {
    SinglePoint three(law, {-20e3, -40e3, -20e3, 3e3});
    PointTest plane(law, {-20e3, -40e3, -20e3, 3e3});
    for (int n = 0; n < 20; ++n) {
      const double sign = n < 12 ? 1.0 : -1.0;
      three.move({1e-4, -2e-4, 0.0, sign * 5e-4}, 0.01);
      plane.apply({Control::strain(1e-4), Control::strain(-2e-4), Control::strain(sign * 5e-4), 0.01});
    }
    EXPECT_EQ(three.stress.xx, plane.stress().xx) << name(law);
    EXPECT_EQ(three.stress.zz, plane.stress().zz) << name(law);
    EXPECT_EQ(three.stress.xy, plane.stress().xy) << name(law);
    EXPECT_EQ(three.plastic_work, plane.plastic_work()) << name(law);
  }
}

/// Elastic energy + plastic work = trapezoidal work of all four components, without remainder.
TEST(OutOfPlane, PlasticWorkClosesTheEnergyBalance) {
  for (const Law& law : laws()) {
    SinglePoint point(law, {-20e3, -40e3, -20e3, 0.0});
    const auto energy = [&] {
      const PointStress& s = point.stress;
      return elastic.energy_density(s.xx, s.yy, s.zz, s.xy);
    };
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const double start = energy();
    double work = 0.0;
    double throughput = 0.0;
    for (int n = 0; n < 500; ++n) {
      const PointStress a = point.stress;
      const Strain3 step = {2e-4 * unit(random), 2e-4 * unit(random), 2e-4 * unit(random),
                            1e-3 * unit(random)};
      point.move(step);
      const PointStress& b = point.stress;
      const double done = 0.5 * ((a.xx + b.xx) * step.xx + (a.yy + b.yy) * step.yy + (a.zz + b.zz) * step.zz +
                                 (a.xy + b.xy) * step.xy);
      work += done;
      throughput += std::abs(done);
    }
    EXPECT_NEAR(work, energy() - start + point.plastic_work, 1e-9 * throughput) << name(law);
    EXPECT_TRUE(point.plastic_work > 0.0 || name(law) == "linear_elastic");
  }
}

} // namespace
} // namespace tremolo::materials::test
