// A million random steps of strain and rotation on random soils: stresses stay finite and on or inside the
// surface, plastic strain only grows, and the stress at the end of a step never does negative work on its
// plastic strain.

#include "surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tremolo::materials {
namespace {

using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Any soil that validate() accepts, with cohesion or friction or both, with or without dilation and cut-off.
MohrCoulomb random_soil(Random& random) {
  MohrCoulomb soil;
  soil.elastic = {1700.0, 40e6, between(random, 0.0, 0.45)};
  soil.cohesion_peak = random() % 3 == 0 ? 0.0 : between(random, 0.0, 20e3);
  soil.cohesion_residual = random() % 2 == 0 ? 0.0 : soil.cohesion_peak;
  soil.friction_peak = between(random, 0.1, 0.8);
  soil.friction_residual = between(random, 0.05, soil.friction_peak);
  if (random() % 2 == 0) {
    soil.dilation_residual = between(random, 0.0, soil.friction_residual);
    soil.dilation_peak = between(random, soil.dilation_residual, soil.friction_peak);
  }
  soil.softening = random() % 3 == 0 ? 0.0 : between(random, 0.0, 60.0);
  if (random() % 2 == 0) {
    soil.tension_cutoff = between(random, 0.0, 10e3);
  }
  return soil;
}

PointStep random_step(Random& random) {
  const double size = std::pow(10.0, between(random, -6.0, -2.0));
  return {Control::strain(size * between(random, -1.0, 1.0)),
          Control::strain(size * between(random, -1.0, 1.0)),
          Control::strain(size * between(random, -1.0, 1.0)), size * between(random, -1.0, 1.0)};
}

TEST(RandomPaths, StayOnOrInsideTheSurface) {
  Random random(20240117);
  constexpr int soils = 5000;
  constexpr int steps = 200;
  double worst_excess = 0.0;
  double least_work = 0.0;
  for (int k = 0; k < soils; ++k) {
    const MohrCoulomb soil = random_soil(random);
    PointTest point(soil, {-20e3, -40e3, -20e3, 0.0});
    for (int n = 0; n < steps; ++n) {
      const PointStep step = random_step(random);
      PointTest elastic(LinearElastic{soil.elastic}, point.stress());
      elastic.apply(step);
      const double before = point.state()[equivalent_plastic_strain];
      point.apply(step);
      const PointStress s = point.stress();
      const double e = point.state()[equivalent_plastic_strain];
      ASSERT_TRUE(std::isfinite(s.xx) && std::isfinite(s.yy) && std::isfinite(s.zz) && std::isfinite(s.xy) &&
                  std::isfinite(point.plastic_work()));
      ASSERT_GE(e, before);
      const Extremes trial = principal(elastic.stress());
      const double scale = 1.0 + std::abs(trial.largest) + std::abs(trial.smallest); // Pa
      worst_excess = std::max(worst_excess, excess(soil, s, e) / scale);
      least_work = std::min(least_work, end_work(soil.elastic, elastic.stress(), s) * soil.elastic.young /
                                            (scale * scale));
    }
  }
  EXPECT_LT(worst_excess, 1e-9);
  EXPECT_GT(least_work, -1e-9);
}

/// Trapezoidal work of the whole step = change of elastic energy + plastic work, without remainder.
TEST(RandomPaths, PlasticWorkClosesTheEnergyBalance) {
  Random random(7);
  for (int k = 0; k < 200; ++k) {
    const MohrCoulomb soil = random_soil(random);
    PointTest point(soil, {-5e3, -5e3, -5e3, 0.0});
    const auto energy = [&] {
      const PointStress s = point.stress();
      return soil.elastic.energy_density(s.xx, s.yy, s.zz, s.xy);
    };
    const double start = energy();
    double work = 0.0;
    double throughput = 0.0;
    for (int n = 0; n < 100; ++n) {
      PointStep step = random_step(random);
      step.rotation = 0.0;
      const PointStress a = point.stress();
      point.apply(step);
      const PointStress b = point.stress();
      const double done = 0.5 * ((a.xx + b.xx) * step.xx.value() + (a.yy + b.yy) * step.yy.value() +
                                 (a.xy + b.xy) * step.xy.value());
      work += done;
      throughput += std::abs(done);
    }
    EXPECT_NEAR(work, energy() - start + point.plastic_work(), 1e-9 * throughput);
  }
}

} // namespace
} // namespace tremolo::materials
