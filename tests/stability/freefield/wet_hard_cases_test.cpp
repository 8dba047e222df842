// Hard cases of water in the column: permeabilities over eight orders, sand that stays liquefied for a
// minute, ten minutes of reconsolidation.

#include "tests/support/liquefying_column.hpp"
#include "tests/support/saturated_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::freefield::testing {
namespace {

/// Case 20: layers of 1e-1 to 1e-9 m/s under a load and shaking, with the step of the fast wave alone.
TEST(WetHardCases, PermeabilitiesOverEightOrdersKeepTheStepAndThePressure) {
  const Profile profile =
      wet_profile({wet_layer(2.0, 1e8, 1e-5), wet_layer(2.0, 1e8, 1e-1), wet_layer(2.0, 1e8, 1e-9),
                   wet_layer(2.0, 1e8, 1e-3), wet_layer(2.0, 1e8, 1e-7)});
  auto settings = wet_settings(profile, 0.25, 0.95);
  constexpr double load = 1e5;
  settings.surface_load = [](double time) {
    const double s = std::clamp(time / 0.5, 0.0, 1.0);
    return -load * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
  };
  TwoPhaseColumn column(profile, settings, at_rest);
  while (column.time() < 20.0) {
    for (int i = 0; i < 100; ++i)
      column.step();
    for (const double y : evenly(-9.875, -0.125, 0.25)) {
      const double p = sample_at(column, y).pore_pressure / load;
      ASSERT_GE(p, -0.01) << y << " m, " << column.time() << " s";
      ASSERT_LE(p, 1.01) << y << " m, " << column.time() << " s";
    }
  }
  // Behind the tight layer nothing has drained, and pressure is even where water flows easily.
  EXPECT_NEAR(sample_at(column, -6.5).pore_pressure, sample_at(column, -7.5).pore_pressure, 0.01 * load);
  EXPECT_GT(sample_at(column, -7.0).pore_pressure, 0.9 * load);
}

/// Case 24: 0.2 g in sand that has lost its strength.
void expect_bounded_liquefaction(double end) {
  for (const auto& sand : {pm4sand_column("", 0.35, 476.0, 0.53, 1e-4), pdmy03_column("")}) {
    const double w = 2.0 * std::numbers::pi;
    constexpr double peak = 1.962 / (2.0 * std::numbers::pi); // m/s
    const auto shaking = [w](double t) {
      return Velocity{t > 0.0 ? peak * (1.0 - std::cos(w * t)) * std::min(t, 1.0) : 0.0, 0.0};
    };
    TwoPhaseColumn column(liquefying_profile(sand), liquefying_settings(0.5, 2e-4), shaking);
    double fastest = 0.0, highest = 0.0;
    const double initial = 5.0 * 9.81 * 973.45;
    while (column.time() < end) {
      for (int i = 0; i < 50; ++i)
        column.step();
      for (const double y : evenly(-9.75, -0.25, 0.5)) {
        const auto sample = sample_at(column, y);
        fastest = std::max({fastest, std::abs(sample.vx), std::abs(sample.vy)});
      }
      highest = std::max(highest, sample_at(column, -5.0).pore_pressure / initial);
    }
    EXPECT_GT(highest, 0.9) << materials::name(sand.law);
    EXPECT_LT(fastest, 3.0 * 2.0 * peak + 1.0) << materials::name(sand.law);
  }
}

TEST(WetHardCases, LiquefactionStaysBounded) {
  expect_bounded_liquefaction(20.0);
}

TEST(AcceptanceWetHardCases, AMinuteOfLiquefactionStaysBounded) {
  expect_bounded_liquefaction(60.0);
}

/// Case 27: minutes after shaking the ground is at rest, and has settled by the water that left it.
/// @param permeability  m/s
/// @param end           s
void expect_reconsolidation(double permeability, double end) {
  const auto sand = pm4sand_column("", 0.55, 677.0, 0.40, permeability);
  const Profile profile = liquefying_profile(sand);
  TwoPhaseColumn column(profile, liquefying_settings(1.0, 4.8e-4), BaseShaking(0.981));
  double outflow = 0.0, before = 2.0;
  const double weight = 9.81 * materials::buoyant_density(*profile.layers[0].pores, {}) * 5.0;
  double next = 30.0;
  while (column.time() < end) {
    column.step();
    outflow += column.flux().back() * column.time_step();
    if (column.time() >= next) {
      const double ratio = sample_at(column, -5.0).pore_pressure / weight;
      EXPECT_LE(ratio, before + 1e-6) << column.time();
      before = ratio;
      next += 10.0;
    }
  }
  const double settlement = -sample_at(column, 0.0).uy;
  EXPECT_NEAR(outflow, settlement, 0.005 * settlement);
  EXPECT_GT(settlement, 0.005);
  EXPECT_LT(before, 1e-3);
  EXPECT_LT(std::abs(sample_at(column, 0.0).vx), 1e-6);
}

TEST(WetHardCases, ReconsolidationClosesTheWaterBalance) {
  expect_reconsolidation(1e-3, 100.0);
}

TEST(AcceptanceWetHardCases, TenMinutesOfReconsolidationCloseTheWaterBalance) {
  expect_reconsolidation(1e-4, 600.0);
}

} // namespace
} // namespace tremolo::freefield::testing
