// Strain out of plane, as element tests with axial symmetry need it: Hooke's law in three dimensions, and the
// energy balance of the laws that dissipate.

#include "materials/law/driver.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace tremolo::materials {
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

PointStep step_of(double xx, double yy, double zz, double xy) {
  return {.xx = Control::strain(xx),
          .yy = Control::strain(yy),
          .xy = Control::strain(xy),
          .zz = Control::strain(zz)};
}

std::vector<Law> laws() {
  return {LinearElastic{elastic}, friction_soil(), iwan_shear(elastic, 5e-4, 1.0, 0.92),
          DruckerPrager{elastic, 5e3, 0.6, 0.1, ConeMatch::triaxial_compression},
          multi_yield_clay(elastic, 40e3)};
}

/// E and nu, from the strains: eps_yy = s/E, eps_xx = eps_zz = -nu s/E under a stress s along y alone.
TEST(OutOfPlane, UniaxialStressFollowsHooke) {
  PointTest point(LinearElastic{elastic}, {});
  const double axial = -1e-3;
  for (int n = 0; n < 10; ++n) {
    point.apply(step_of(-0.028 * axial, 0.1 * axial, -0.028 * axial, 0.0));
  }
  EXPECT_NEAR(point.stress().yy, 40e6 * axial, 1e-8 * 40e3);
  EXPECT_NEAR(point.stress().xx, 0.0, 1e-8 * 40e3);
  EXPECT_NEAR(point.stress().zz, 0.0, 1e-8 * 40e3);
}

/// Isotropic strain: three times the bulk modulus, in every law while it is elastic or does not know
/// pressure.
TEST(OutOfPlane, IsotropicCompressionFollowsTheBulkModulus) {
  for (const Law& law : laws()) {
    PointTest point(law, {-10e3, -10e3, -10e3, 0.0});
    point.apply(step_of(-1e-4, -1e-4, -1e-4, 0.0));
    const double expected = -10e3 - 3e-4 * elastic.bulk_modulus();
    EXPECT_NEAR(point.stress().xx, expected, 1e-6) << name(law);
    EXPECT_NEAR(point.stress().yy, expected, 1e-6) << name(law);
    EXPECT_NEAR(point.stress().zz, expected, 1e-6) << name(law);
  }
}

/// Zero strain out of plane is plane strain, bit by bit.
TEST(OutOfPlane, ZeroIsPlaneStrain) {
  for (const Law& law : laws()) {
    std::vector<double> stress[2] = {{-20e3, -40e3, -20e3, 3e3}, {-20e3, -40e3, -20e3, 3e3}};
    double work[2] = {0.0, 0.0};
    const std::array strain = {1e-4, -2e-4, 5e-4, 0.01};
    const double none = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<double> state(state_variables(law).size());
      Points points = {1,        &stress[k][0], &stress[k][1], &stress[k][2], &stress[k][3], state.data(),
                       &work[k], &strain[0],    &strain[1],    &strain[2],    &strain[3]};
      points.dezz = k == 0 ? nullptr : &none;
      initialise(law, points);
      for (int n = 0; n < 20; ++n) {
        update(law, points);
      }
    }
    EXPECT_EQ(stress[0], stress[1]) << name(law);
    EXPECT_EQ(work[0], work[1]) << name(law);
  }
}

/// Elastic energy + plastic work = trapezoidal work of all four components, without remainder.
TEST(OutOfPlane, PlasticWorkClosesTheEnergyBalance) {
  for (const Law& law : laws()) {
    PointTest point(law, {-20e3, -40e3, -20e3, 0.0});
    const auto energy = [&] {
      const PointStress& s = point.stress();
      return elastic.energy_density(s.xx, s.yy, s.zz, s.xy);
    };
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const double start = energy();
    double work = 0.0;
    double throughput = 0.0;
    for (int n = 0; n < 500; ++n) {
      const PointStress a = point.stress();
      const PointStep step =
          step_of(2e-4 * unit(random), 2e-4 * unit(random), 2e-4 * unit(random), 1e-3 * unit(random));
      point.apply(step);
      const PointStress& b = point.stress();
      const double done = 0.5 * ((a.xx + b.xx) * step.xx.value() + (a.yy + b.yy) * step.yy.value() +
                                 (a.zz + b.zz) * step.zz.value() + (a.xy + b.xy) * step.xy.value());
      work += done;
      throughput += std::abs(done);
    }
    EXPECT_NEAR(work, energy() - start + point.plastic_work(), 1e-9 * throughput) << name(law);
    EXPECT_TRUE(point.plastic_work() > 0.0 || name(law) == "linear_elastic");
  }
}

} // namespace
} // namespace tremolo::materials
