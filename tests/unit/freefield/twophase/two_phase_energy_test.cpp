// Where the energy of the column of soil and water goes: the ledger closes, to second order in the step, and
// its entries are what stress, pressure and flow say by themselves.

#include "tests/support/saturated_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::freefield::testing {
namespace {

/// So weak that lengths and masses stay as they are.
Velocity shaking(double time) {
  const double a = std::pow(std::numbers::pi * 4.0 * (time - 0.4), 2);
  const double v = 1e-4 * (1.0 - 2.0 * a) * std::exp(-a);
  return {v, -0.4 * v};
}

/// Coupled, undrained, drained and dry soil, damped.
Profile mixed_profile() {
  Profile profile = wet_profile({wet_layer(2.0, 1e8, 1e-3), wet_layer(2.0, 5e7, 1e-1, 0.45),
                                 wet_layer(2.0, 2e8, 1e-3), wet_layer(2.0, 2e8, 1e-5)});
  profile.layers[0].pores.reset();
  profile.layers[0].damping_ratio = 0.05;
  profile.layers[1].damping_ratio = 0.02;
  profile.layers[2].pores->drainage = materials::Drainage::undrained;
  profile.layers[3].pores->drainage = materials::Drainage::drained;
  profile.water->level = -2.0;
  return profile;
}

/// The largest part of the energy given that the ledger misses at any time.
double missing(BaseKind base, const Damping& damping, double share) {
  const Profile profile = mixed_profile();
  TwoPhaseSettings settings{.max_element_size = 0.5,
                            .time_step = share * two_phase_step_limit(profile, 0.5, damping),
                            .damping = damping,
                            .base = base};
  settings.surface_load = [](double time) {
    return 2.0 * std::sin(20.0 * time) * std::min(10.0 * time, 1.0);
  };
  TwoPhaseColumn column(profile, settings, shaking);
  double worst = 0.0;
  while (column.time() < 1.0) {
    column.step();
    worst = std::max(worst, std::abs(column.energy().missing()));
  }
  const WetEnergy energy = column.energy();
  EXPECT_GT(energy.drag, 0.01 * energy.given());
  EXPECT_GT(energy.damping, 0.01 * energy.given());
  return worst / energy.given();
}

TEST(TwoPhaseEnergy, ClosesToSecondOrder) {
  for (const BaseKind base : {BaseKind::compliant, BaseKind::rigid})
    for (const Damping& damping : {Damping{KelvinVoigtDamping{4.0}}, Damping{RayleighDamping{1.0, 8.0}}}) {
      const double coarse = missing(base, damping, 0.8);
      const double fine = missing(base, damping, 0.4);
      EXPECT_LT(coarse, 1e-3);
      EXPECT_GT(std::log2(coarse / fine), 1.8);
    }
}

/// Energy of linear soil and of water is a function of stress and pressure.
TEST(TwoPhaseEnergy, WorkOnSoilAndWaterIsWhatTheyStore) {
  constexpr double modulus = 1e8, load = 2e4;
  const Profile profile = wet_profile({wet_layer(5.0, modulus, 1e-3)});
  auto settings = wet_settings(profile, 0.25);
  settings.surface_load = [](double time) { return -load * std::clamp(time / 0.1, 0.0, 1.0); };
  TwoPhaseColumn column(profile, settings, at_rest);
  const double stiffness = materials::pore_stiffness(*profile.layers[0].pores, water);
  double largest = 0.0; // of the water's energy
  for (const double time : {0.15, 0.5, 2.0}) {
    march(column, time);
    double soil = 0.0, pores = 0.0;
    for (const double y : evenly(-4.875, -0.125, 0.25)) {
      const ColumnSample at = sample_at(column, y);
      const double effective = at.syy + at.pore_pressure;
      soil += 0.25 * 0.5 * effective * effective / modulus;
      pores += 0.25 * 0.5 * at.pore_pressure * at.pore_pressure / stiffness;
    }
    largest = std::max(largest, pores);
    // Strain of 2e-4 makes as much difference.
    EXPECT_NEAR(column.energy().elastic - column.energy().gravity, soil, 1e-3 * soil) << time;
    EXPECT_NEAR(column.energy().pore, pores, 1e-3 * largest) << time;
  }
}

/// A load q put on in the time factor T_r does the work q^2 H/M (1 - (8/15) sqrt(T_r/pi)) until all water has
/// left, of which the soil stores a half, and drag takes the rest.
TEST(TwoPhaseEnergy, ConsolidationLosesWhatSoilDoesNotStore) {
  constexpr double modulus = 1e7, load = 1e4, ramp = 0.002;
  const Profile profile = wet_profile({wet_layer(1.0, modulus, 1e-3)});
  const double c_v = materials::consolidation_coefficient(modulus, *profile.layers[0].pores, water, gravity);
  auto settings = wet_settings(profile, 0.025);
  settings.surface_load = [c_v](double time) { return -load * std::clamp(time * c_v / ramp, 0.0, 1.0); };
  TwoPhaseColumn column(profile, settings, at_rest);
  march(column, 3.0 / c_v);
  const WetEnergy energy = column.energy();
  const double unit = load * load / modulus;
  const double given = 1.0 - 8.0 / 15.0 * std::sqrt(ramp / std::numbers::pi);
  EXPECT_NEAR(energy.load / unit, given, 0.003);
  EXPECT_NEAR(energy.drag / unit, given - 0.5, 0.003);
  EXPECT_LT(energy.pore, 1e-3 * unit);
  EXPECT_LT(std::abs(energy.missing()), 1e-5 * energy.load);
}

} // namespace
} // namespace tremolo::freefield::testing
