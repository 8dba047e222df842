#include "materials/law/driver.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace tremolo::materials {
namespace {

const Elasticity soil{1700.0, 40e6, 0.28};

TEST(Elasticity, ConstantsOfTheSlopeSoil) {
  EXPECT_NEAR(soil.shear_modulus(), 15.625e6, 1.0);
  EXPECT_NEAR(soil.bulk_modulus(), 30.303e6, 1e3);
  EXPECT_NEAR(soil.p_modulus(), 51.136e6, 1e3);
  EXPECT_NEAR(soil.s_wave_speed(), 95.87, 0.01);
  EXPECT_NEAR(soil.p_wave_speed(), 173.44, 0.01);
  EXPECT_NEAR(soil.rest_coefficient(), 0.3889, 1e-4);
}

TEST(Elasticity, WaveSpeedsAndModuliAreEquivalent) {
  const Elasticity back = Elasticity::from_wave_speeds(1700.0, soil.s_wave_speed(), soil.p_wave_speed());
  EXPECT_NEAR(back.young, soil.young, 1e-6);
  EXPECT_NEAR(back.poisson, soil.poisson, 1e-12);
}

/// Hooke's law in plane strain, written with E and nu.
TEST(LinearElastic, FollowsHooke) {
  PointTest point(LinearElastic{soil}, {});
  const double exx = 1e-3;
  const double eyy = -2e-3;
  const double gxy = 5e-4;
  for (int n = 0; n < 10; ++n) {
    point.apply({Control::strain(exx / 10), Control::strain(eyy / 10), Control::strain(gxy / 10)});
  }
  const double nu = soil.poisson;
  const double factor = soil.young / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const PointStress s = point.stress();
  EXPECT_NEAR(s.xx, factor * ((1.0 - nu) * exx + nu * eyy), 1e-6);
  EXPECT_NEAR(s.yy, factor * ((1.0 - nu) * eyy + nu * exx), 1e-6);
  EXPECT_NEAR(s.zz, nu * (s.xx + s.yy), 1e-6);
  EXPECT_NEAR(s.xy, soil.young / (2.0 * (1.0 + nu)) * gxy, 1e-6);
}

TEST(LinearElastic, EnergyIsTheWorkDone) {
  PointTest point(LinearElastic{soil}, {});
  const double exx = 1e-3;
  const double eyy = -2e-3;
  const double gxy = 5e-4;
  point.apply({Control::strain(exx), Control::strain(eyy), Control::strain(gxy)});
  const PointStress s = point.stress();
  EXPECT_NEAR(soil.energy_density(s.xx, s.yy, s.zz, s.xy), 0.5 * (s.xx * exx + s.yy * eyy + s.xy * gxy),
              1e-9);
}

/// Every point of a block, whatever the block's length, gets what it would get alone.
TEST(Blocks, PointsDoNotAffectEachOther) {
  MohrCoulomb law;
  law.elastic = soil;
  law.cohesion_peak = 4e3;
  law.friction_peak = std::numbers::pi / 4.0;
  law.friction_residual = 0.5;
  law.softening = 15.0;
  constexpr std::size_t count = 1001;
  std::vector<double> sxx(count, -50e3), syy(count, -80e3), szz(count, -50e3), sxy(count, 0.0),
      state(count, 0.0);
  std::vector<double> work(count, 0.0), dexx(count, 0.0), deyy(count, 0.0), dgxy(count), dwxy(count, 1e-3);
  for (std::size_t i = 0; i < count; ++i) {
    dgxy[i] = 1e-5 * static_cast<double>(i);
  }
  Points points{count,       sxx.data(),  syy.data(),  szz.data(),  sxy.data(), state.data(),
                work.data(), dexx.data(), deyy.data(), dgxy.data(), dwxy.data()};
  update(law, points);
  for (std::size_t i = 0; i < count; i += 7) {
    PointTest alone(law, {-50e3, -80e3, -50e3, 0.0});
    alone.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(dgxy[i]), 1e-3});
    EXPECT_DOUBLE_EQ(sxx[i], alone.stress().xx);
    EXPECT_DOUBLE_EQ(sxy[i], alone.stress().xy);
    EXPECT_DOUBLE_EQ(state[i], alone.state()[equivalent_plastic_strain]);
    EXPECT_DOUBLE_EQ(work[i], alone.plastic_work());
  }
}

} // namespace
} // namespace tremolo::materials
