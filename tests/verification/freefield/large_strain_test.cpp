// Consolidation by tens of per cent in the two-phase column, against closed forms for soil with the stress
// sigma' = M ln J, J its volume over that at rest, and constant permeability.

#include "tests/support/saturated_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::freefield::testing {
namespace {

constexpr double modulus = 1e6;        // M, Pa
constexpr double load = 0.5 * modulus; // Pa
constexpr double porosity = 0.7;

Profile soft_ground(double height) {
  return wet_profile({wet_layer(height, modulus, 1e-3, porosity)});
}

TwoPhaseSettings loaded(const Profile& profile, double element_size, double ramp) {
  auto settings = wet_settings(profile, element_size, 0.5); // elements will be shorter
  settings.surface_load = [ramp](double time) { return -load * std::clamp(time / ramp, 0.0, 1.0); };
  return settings;
}

/// Grains of density rho over that at rest obey d rho/dt = D d2 rho/dz2, D = k M/(rho_f g), z down from where
/// the surface was, since their flux is rho v_s = -D d rho/dz (Gibson, England & Hussey 1967, with this
/// stress and k). The surface of deep ground, at z = s with rho_s = exp(q/M), moves at that velocity:
///
///     s = 2 lambda sqrt(D t),    1 - 1/rho_s = sqrt(pi) lambda exp(lambda^2) erfc(lambda).
double similarity() {
  const double wanted = 1.0 - std::exp(-load / modulus);
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high);
    (std::sqrt(std::numbers::pi) * x * std::exp(x * x) * std::erfc(x) < wanted ? low : high) = x;
  }
  return low;
}

TEST(LargeStrain, DeepGroundSettlesByTheSimilaritySolution) {
  constexpr double height = 2.0;
  const Profile profile = soft_ground(height);
  TwoPhaseColumn column(profile, loaded(profile, 0.02, 5e-3), at_rest);
  const double diffusion = 1e-3 * modulus / unit_weight;
  // The load's growth shifts the origin of time, which the difference of two times does not see.
  const auto square = [&](double time) {
    march(column, time);
    return std::pow(sample_at(column, 0.0).uy, 2);
  };
  const double lambda = similarity();
  double before = square(0.25);
  for (const double time : {0.5, 1.0, 2.0}) {
    const double now = square(time);
    const double exact = 4.0 * lambda * lambda * diffusion * 0.5 * time;
    EXPECT_NEAR(now - before, exact, 0.01 * exact) << time;
    before = now;
  }
  // Small strain, of which the square is 4/pi (q/M)^2 D t, is 13 % off.
  EXPECT_GT(std::abs(std::pow(lambda, 2) * std::numbers::pi / 0.25 - 1.0), 0.1);
}

TEST(LargeStrain, AllWaterThatLeavesIsSettlement) {
  constexpr double height = 0.5;
  const Profile profile = soft_ground(height);
  TwoPhaseColumn column(profile, loaded(profile, 0.05, 0.05), at_rest);
  double outflow = 0.0;
  while (column.time() < 15.0) {
    column.step();
    outflow += column.time_step() * column.flux().back();
  }
  const double stretch = std::exp(-load / modulus);
  EXPECT_NEAR(-sample_at(column, 0.0).uy, height * (1.0 - stretch), 1e-4 * height);
  EXPECT_NEAR(outflow, height * (1.0 - stretch), 1e-4 * height);
  for (std::size_t e = 0; e < 10; ++e)
    EXPECT_NEAR(column.porosity(e), 1.0 - (1.0 - porosity) / stretch, 1e-4) << e;
}

} // namespace
} // namespace tremolo::freefield::testing
