// Slow flow of water in the two-phase column: consolidation under a load (Terzaghi), in two layers of
// different permeability, flow under a constant head, and rest.

#include "tests/support/saturated_ground.hpp"
#include "tests/support/two_layer_consolidation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::freefield::testing {
namespace {

/// p/q at height z over the impervious base of a layer of height 1, after the time factor t (Terzaghi 1943).
double terzaghi(double z, double t) {
  double sum = 0.0;
  for (int m = 0; m < 400; ++m) {
    const double root = std::numbers::pi * (2 * m + 1) / 2.0;
    sum += 2.0 / root * std::sin(root * (1.0 - z)) * std::exp(-root * root * t);
  }
  return sum;
}

/// The solution under a load that grows linearly until `ramp`, by Simpson's rule over the moments of loading.
double ramped(double z, double t, double ramp) {
  constexpr int intervals = 20;
  double sum = 0.0;
  for (int i = 0; i <= intervals; ++i) {
    const double weight = i == 0 || i == intervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * terzaghi(z, t - ramp * i / intervals);
  }
  return sum / (3.0 * intervals);
}

struct Consolidation {
  double modulus, permeability;
};

class Terzaghi : public ::testing::TestWithParam<Consolidation> {};

TEST_P(Terzaghi, PorePressureAndSettlementFollowTheSeries) {
  const auto [modulus, permeability] = GetParam();
  constexpr double load = 1e4; // Pa
  const Profile profile = wet_profile({wet_layer(1.0, modulus, permeability)});
  const double c_v = materials::consolidation_coefficient(modulus, *profile.layers[0].pores, water, gravity);
  constexpr double ramp = 0.002;
  auto settings = wet_settings(profile, 0.05);
  settings.surface_load = [c_v](double time) { return -load * std::clamp(time * c_v / ramp, 0.0, 1.0); };
  TwoPhaseColumn column(profile, settings, at_rest);
  // Water takes all but M/(M + Q) of the load.
  const double q = materials::pore_stiffness(*profile.layers[0].pores, water);
  const double taken = q / (modulus + q);
  for (const double factor : {0.05, 0.2, 0.5}) {
    march(column, factor / c_v);
    double squares = 0.0;
    int count = 0;
    for (const double z : evenly(0.025, 0.975, 0.05)) {
      ++count;
      const double error = sample_at(column, z - 1.0).pore_pressure / load - taken * ramped(z, factor, ramp);
      squares += error * error;
    }
    EXPECT_LE(std::sqrt(squares / count), 0.005) << "rms of p/q at T_v = " << factor;
    double mean = 0.0; // of p/q, Simpson's rule
    for (int i = 0; i <= 200; ++i)
      mean += (i == 0 || i == 200 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / 600.0 * ramped(i / 200.0, factor, ramp);
    const double settlement = -sample_at(column, 0.0).uy;
    EXPECT_NEAR(settlement / (load / modulus), 1.0 - taken * mean, 0.003) << "at T_v = " << factor;
  }
}

INSTANTIATE_TEST_SUITE_P(TwoPhase, Terzaghi,
                         ::testing::Values(Consolidation{1e7, 1e-3}, Consolidation{1e7, 1e-4},
                                           Consolidation{1e8, 1e-5}),
                         [](const auto& one) { return "Case" + std::to_string(one.index + 1); });

TEST(TwoPhaseColumnVerification, TwoLayersConsolidateLikeTheirEigenfunctions) {
  // A tight layer over a permeable one that is half as stiff.
  const Profile profile = wet_profile({wet_layer(1.0, 2e7, 1e-4), wet_layer(2.0, 1e7, 1e-3, 0.45)});
  const auto c_of = [&](std::size_t i, double modulus) {
    return materials::consolidation_coefficient(modulus, *profile.layers[i].pores, water, gravity);
  };
  const double c1 = c_of(0, 2e7), c2 = c_of(1, 1e7);
  const test_support::TwoLayers exact(1.0, c1, 1e-4, 2.0, c2, 1e-3);
  constexpr double load = 1e4;
  auto settings = wet_settings(profile, 0.1);
  constexpr double ramp = 0.02; // s, short of all times of consolidation
  settings.surface_load = [](double time) { return -load * std::clamp(time / ramp, 0.0, 1.0); };
  TwoPhaseColumn column(profile, settings, at_rest);
  for (const double time : {1.0, 5.0, 15.0}) {
    march(column, time);
    double squares = 0.0;
    int count = 0;
    for (const double d : evenly(0.05, 2.95, 0.1)) {
      ++count;
      const double error = sample_at(column, -d).pore_pressure / load - exact.pressure(d, time - 0.5 * ramp);
      squares += error * error;
    }
    EXPECT_LE(std::sqrt(squares / count), 0.005) << time << " s";
  }
}

class ConstantHead : public ::testing::TestWithParam<double> {};

/// Water driven up through two layers by an excess head at the base: n w = k i, whatever drag and step.
TEST_P(ConstantHead, FluxIsDarcys) {
  const double drag_times_step = GetParam();
  constexpr double modulus = 5e9; // so stiff that steady flow comes soon
  constexpr double size = 1.0;
  // The step does not depend on k, so that k follows from the drag that is wanted.
  const double dt = wet_settings(wet_profile({wet_layer(2.0, modulus, 1.0)}), size).time_step;
  const double k =
      materials::drag_rate(*wet_layer(1.0, modulus, 1.0).pores, water, gravity) * dt / drag_times_step;
  const Profile profile = wet_profile({wet_layer(1.0, modulus, k), wet_layer(1.0, modulus, 3.0 * k, 0.5)});
  auto settings = wet_settings(profile, size);
  constexpr double head = 1e-3; // m, which leaves lengths as they are within 1e-8
  // The head rises within some periods of the waves, which drag then takes.
  const double ramp = 200.0 * settings.time_step;
  settings.base_pressure = [ramp](double time) { return head * unit_weight * std::min(time / ramp, 1.0); };
  TwoPhaseColumn column(profile, settings, at_rest);
  const double c_v = materials::consolidation_coefficient(modulus, *profile.layers[0].pores, water, gravity);
  const double rate = materials::drag_rate(*profile.layers[1].pores, water, gravity);
  march(column, 60.0 / c_v + 2000.0 / rate);
  const double expected = head / (1.0 / k + 1.0 / (3.0 * k));
  for (const double flux : column.flux())
    EXPECT_NEAR(flux / expected, 1.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(TwoPhase, ConstantHead, ::testing::Values(1e-3, 1e-1, 1e1, 1e3),
                         [](const auto& one) { return "Drag" + std::to_string(one.index); });

/// Constant head at one node, at which drag would take 1e6 times the relative velocity in a step: a split
/// that kicks and then damps by exp(-lambda dt) leaves nothing of the flux.
TEST(TwoPhaseColumnVerification, FluxOfANodeIsDarcysAtAnyDrag) {
  constexpr double porosity = 0.4, dt = 2e-4, gradient = 1e3; // Pa/m
  for (const double decade : evenly(-3.0, 6.0, 1.0)) {
    const double drag_times_step = std::pow(10.0, decade);
    WetNode node{.solid = 795.0, .fluid = 200.0, .full = 500.0};
    node.drag = drag_times_step / dt * node.full / (1.0 + node.fluid / node.solid);
    Phases v;
    for (int step = 0; step < 40 || step * drag_times_step < 40.0; ++step)
      v = kicked_apart(node, v, {0.0, 0.5 * gradient}, 0.0, dt);
    // d = n r, r the resistance of half a metre: n w = 0.5 i/r.
    const double flux = porosity * (v.fluid - v.solid);
    EXPECT_NEAR(flux * node.drag / porosity / (0.5 * gradient), 1.0, 1e-6) << drag_times_step;
    EXPECT_NEAR(node.solid * v.solid + node.fluid * v.fluid, 0.0, 1e-10 * std::abs(node.fluid * v.fluid));
  }
}

/// A load that has come to rest leaves no flow and no pressure, whatever the jumps of n and k: the form in
/// which n stands inside the gradient keeps water flowing.
TEST(TwoPhaseColumnVerification, ComesToRestOverJumpsOfPorosityAndPermeability) {
  const Profile profile = wet_profile(
      {wet_layer(1.0, 1e8, 1e-2, 0.35), wet_layer(1.0, 1e8, 1e-4, 0.5), wet_layer(1.0, 1e8, 1e-2, 0.35)});
  auto settings = wet_settings(profile, 0.25);
  constexpr double load = 1e4;
  settings.surface_load = [](double time) { return -load * std::clamp(time / 0.1, 0.0, 1.0); };
  TwoPhaseColumn column(profile, settings, at_rest);
  march(column, 0.2);
  EXPECT_GT(sample_at(column, -2.5).pore_pressure, 0.5 * load);
  march(column, 60.0);
  for (const double flux : column.flux())
    EXPECT_NEAR(flux, 0.0, 1e-12);
  for (const double y : evenly(-3.0, -0.5, 0.5)) {
    EXPECT_NEAR(sample_at(column, y).pore_pressure, 0.0, 1e-6 * load) << y;
    EXPECT_NEAR(sample_at(column, y).syy, -load, 1e-6 * load) << y;
    EXPECT_NEAR(sample_at(column, y).uy, std::expm1(-load / 1e8) * (y + 3.0), 1e-6 * load / 1e8) << y;
  }
}

} // namespace
} // namespace tremolo::freefield::testing
