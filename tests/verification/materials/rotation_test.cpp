// A rigid turn by 90 degrees in the middle of a test changes nothing: the same random strain path twice, the
// second time turned half way, in one increment and in many. Stress, state and work are those of the body
// that stayed.

#include "soils.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tremolo::materials::test {
namespace {

const Elasticity elastic = {1900.0, 60e6, 0.3};

IwanShear reduced_in_loops() {
  IwanShear law = iwan_shear(elastic, 5e-4, 1.0, 0.92);
  law.loops = {0.9, 0.5, 0.7};
  return law;
}

std::vector<Law> laws() {
  MohrCoulomb dilating = perfect_soil(35.0, 10.0, 5.0 * kPa);
  dilating.tension_cutoff = 2.0 * kPa;
  return {LinearElastic{elastic},
          slope_soil(),
          dilating,
          DruckerPrager{elastic, 5.0 * kPa, 35.0 * degree, 5.0 * degree, ConeMatch::plane_strain},
          iwan_shear(elastic, 5e-4, 1.0, 0.92),
          reduced_in_loops(),
          multi_yield_clay({1700.0, 60e6, 0.49}, 40.0 * kPa)};
}

PointTest driven(const Law& law, int turning_steps) {
  PointTest point(law, {-50.0 * kPa, -100.0 * kPa, -60.0 * kPa, 8.0 * kPa});
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int k = 0; k < 400; ++k) {
    const double xx = 1e-3 * unit(random);
    const double yy = 1e-3 * unit(random);
    const double xy = 2e-3 * unit(random);
    for (int n = 0; k == 200 && n < turning_steps; ++n) {
      PointStep turn;
      turn.rotation = 2.0 * std::tan(0.25 * std::numbers::pi / turning_steps);
      point.apply(turn);
    }
    if (k < 200 || turning_steps == 0) {
      point.apply({Control::strain(xx), Control::strain(yy), Control::strain(xy)});
    } else {
      point.apply({Control::strain(yy), Control::strain(xx), Control::strain(-xy)});
    }
  }
  return point;
}

TEST(Rotation, AQuarterTurnInTheMiddleChangesNothing) {
  for (const Law& law : laws()) {
    const PointTest still = driven(law, 0);
    const PointStress& a = still.stress();
    const double scale =
        1e-8 * (std::abs(a.xx) + std::abs(a.yy) + std::abs(a.zz) + std::abs(a.xy) + 1.0 * kPa);
    for (const int steps : {1, 500}) {
      const PointTest turned = driven(law, steps);
      const PointStress& b = turned.stress();
      EXPECT_NEAR(b.xx, a.yy, scale) << name(law) << " in " << steps;
      EXPECT_NEAR(b.yy, a.xx, scale) << name(law) << " in " << steps;
      EXPECT_NEAR(b.zz, a.zz, scale) << name(law) << " in " << steps;
      EXPECT_NEAR(b.xy, -a.xy, scale) << name(law) << " in " << steps;
      EXPECT_NEAR(turned.plastic_work(), still.plastic_work(), 1e-8 * still.plastic_work());
    }
  }
}

} // namespace
} // namespace tremolo::materials::test
