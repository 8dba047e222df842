// Fast motion of the two-phase column: arrival of waves, share of the water in a load, and the harmonic
// column, against closed forms of the two-velocity equations.

#include "tests/support/harmonic_column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>

namespace tremolo::freefield::testing {
namespace {

/// Time at which pressure at a depth first exceeds half of its plateau under a step load.
double arrival(double permeability, double depth, double* plateau) {
  constexpr double load = 1e4;
  constexpr double modulus = 1e8;
  const Profile profile = wet_profile({wet_layer(40.0, modulus, permeability)});
  auto settings = wet_settings(profile, 0.05, 0.9);
  settings.surface_load = [](double time) { return time >= 0.0 ? -load : 0.0; };
  TwoPhaseColumn column(profile, settings, at_rest);
  const double half = 0.5 * 0.98 * load;
  double time = 0.0, before = 0.0;
  while (time == 0.0 && column.time() < 0.03) {
    column.step();
    const double now = sample_at(column, -depth).pore_pressure;
    if (now >= half)
      time = column.time() - column.time_step() * (now - half) / (now - before);
    before = now;
  }
  double sum = 0.0;
  int count = 0;
  for (const double end = column.time() + 0.004; column.time() < end; ++count) {
    column.step();
    sum += sample_at(column, -depth).pore_pressure;
  }
  *plateau = sum / count / load;
  return time;
}

TEST(TwoPhaseColumnVerification, UndrainedFrontRunsAtItsSpeedAndWaterTakesItsShare) {
  const auto pores = *wet_layer(1.0, 1e8, 1e-5).pores;
  const auto speeds = materials::saturated_speeds(1e8, pores, water);
  double plateau = 0.0;
  const double time = arrival(1e-5, 20.0, &plateau);
  EXPECT_NEAR(20.0 / time, speeds.undrained, 0.02 * speeds.undrained);
  EXPECT_NEAR(plateau, 5.5e9 / (1e8 + 5.5e9), 0.005);
}

TEST(TwoPhaseColumnVerification, WithoutDragTheFastWaveRunsAtItsSpeed) {
  const auto pores = *wet_layer(1.0, 1e8, 1.0).pores;
  const auto speeds = materials::saturated_speeds(1e8, pores, water);
  // A total load splits between both waves at a drained surface; a jerk of the base makes the fast one.
  const Profile profile = wet_profile({wet_layer(40.0, 1e8, 1e3)});
  const auto settings = wet_settings(profile, 0.05, 0.9);
  double largest = 0.0, time = 0.0, before = 0.0;
  // The plateau behind the front first, then the time at which half of it arrives.
  for (const int pass : {0, 1}) {
    TwoPhaseColumn run(profile, settings, [](double t) { return Velocity{0.0, t > 0.0 ? 0.01 : 0.0}; });
    while (run.time() < 30.0 / speeds.fast && time == 0.0) {
      run.step();
      const double now = sample_at(run, -20.0).pore_pressure;
      if (pass == 0 && run.time() > 25.0 / speeds.fast && run.time() < 26.0 / speeds.fast)
        largest = now;
      if (pass == 1 && now >= 0.5 * largest)
        time = run.time() - run.time_step() * (now - 0.5 * largest) / (now - before);
      before = now;
    }
  }
  EXPECT_NEAR(20.0 / time, speeds.fast, 0.02 * speeds.fast);
}

/// A load taken slowly by soil that does not drain: p/q = Q/(M + Q), to 0.1 %, coupled or undrained.
TEST(TwoPhaseColumnVerification, UndrainedLoadIsSharedByStiffness) {
  for (const double modulus : {1e7, 1e8, 5e8})
    for (const bool flows : {true, false}) {
      auto layer = wet_layer(5.0, modulus, 1e-9);
      if (!flows)
        layer.pores->drainage = materials::Drainage::undrained;
      const Profile profile = wet_profile({layer});
      auto settings = wet_settings(profile, 0.25);
      constexpr double load = 1e4;
      // A smooth ramp over some ten periods of the column leaves no ringing.
      settings.surface_load = [](double time) {
        const double s = std::clamp(time / 0.2, 0.0, 1.0);
        return -load * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
      };
      TwoPhaseColumn column(profile, settings, at_rest);
      march(column, 0.25);
      const double exact = 5.5e9 / (modulus + 5.5e9);
      EXPECT_NEAR(sample_at(column, -3.0).pore_pressure / load, exact, 1e-3 * exact)
          << modulus << " Pa, " << flows;
    }
}

class Harmonic : public ::testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(Harmonic, PressureAndDisplacementHaveTheirAmplitudes) {
  const auto [frequency, permeability] = GetParam();
  constexpr double height = 10.0, modulus = 1e8, load = 1e4;
  const HarmonicColumn exact(height, modulus, permeability, frequency);
  const Profile profile = wet_profile({wet_layer(height, modulus, permeability)});
  auto settings = wet_settings(profile, 0.1);
  const double w = 2.0 * std::numbers::pi * frequency;
  // Grows over six periods: what it starts dies out by drag, over the next twelve.
  settings.surface_load = [w](double time) {
    const double s = std::clamp(time * w / (2.0 * std::numbers::pi) / 6.0, 0.0, 1.0);
    return load * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s) * std::sin(w * time);
  };
  TwoPhaseColumn column(profile, settings, at_rest);
  march(column, 18.0 / frequency);
  const double begin = column.time();
  const double depths[] = {9.94, 4.94, 0.94};
  std::complex<double> pressures[3], top;
  const auto steps = static_cast<long>(std::lround(2.0 / frequency / column.time_step()));
  for (long i = 0; i < steps; ++i) {
    column.step();
    const auto phase = std::polar(2.0 / static_cast<double>(steps), -w * (column.time() - begin));
    for (int k = 0; k < 3; ++k)
      pressures[k] += phase * sample_at(column, -depths[k]).pore_pressure;
    top += phase * sample_at(column, 0.0).uy;
  }
  for (int k = 0; k < 3; ++k) {
    const double amplitude = std::abs(exact.pressure(height - depths[k]));
    EXPECT_NEAR(std::abs(pressures[k]) / load, amplitude, 0.005 * amplitude) << depths[k] << " m deep";
  }
  const double displacement = std::abs(exact.displacement(height));
  EXPECT_NEAR(std::abs(top) / load, displacement, 0.005 * displacement);
}

INSTANTIATE_TEST_SUITE_P(TwoPhase, Harmonic,
                         ::testing::Values(std::tuple(2.0, 1e-3), std::tuple(2.0, 1e-2),
                                           std::tuple(10.0, 1e-3)),
                         [](const auto& one) { return "Case" + std::to_string(one.index + 1); });

/// The closed form itself, against values that were computed apart, at heights rounded to a centimetre: near
/// the surface |p| falls by 0.007 a centimetre.
TEST(TwoPhaseColumnVerification, HarmonicClosedFormHasItsKnownValues) {
  const HarmonicColumn column(10.0, 1e8, 1e-3, 2.0);
  EXPECT_NEAR(std::abs(column.pressure(0.06)), 0.9850, 2e-4);
  EXPECT_NEAR(std::abs(column.pressure(5.06)), 0.9984, 2e-4);
  EXPECT_NEAR(std::abs(column.pressure(9.06)), 0.7126, 4e-3);
  EXPECT_NEAR(std::abs(column.displacement(10.0)) * 1e7, 0.10112, 2e-5);
}

} // namespace
} // namespace tremolo::freefield::testing
