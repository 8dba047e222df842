// Columns at the edge of what they are asked to do.

#include "freefield/twophase/two_phase_column.hpp"
#include "tests/support/layered_column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;
using tremolo::testing::LayeredColumn;

const Elasticity rock = Elasticity::from_wave_speeds(2200.0, 800.0, 1500.0);

InputVelocity ricker(double velocity, double frequency, double time) {
  return [=](double t) {
    const double a = std::pow(std::numbers::pi * frequency * (t - time), 2);
    const double v = velocity * (1.0 - 2.0 * a) * std::exp(-a);
    return Velocity{v, 0.3 * v};
  };
}

ColumnSample at(const Column& column, double y) {
  ColumnSample sample;
  column.sample({&y, 1}, {&sample, 1});
  return sample;
}

// MKZ soil far beyond its reference strain: the hysteresis takes most of the energy, and the ledger closes.
TEST(DryHardCases, StrainAboveFivePerCent) {
  const Elasticity soil = Elasticity::from_wave_speeds(1700.0, 120.0, 240.0);
  const Profile profile{
      .layers = {layer_of(20.0, MasingShear{.elastic = soil, .reference_strain = 5e-4, .exponent = 0.92})},
      .half_space = rock,
      .gravity = 9.81};
  const double dt = 0.8 * two_phase_step_limit(profile, 0.5, Damping{}); // vertical strain is 5 %
  TwoPhaseColumn column(profile, {0.5, dt}, ricker(0.6, 1.0, 1.2));
  double strain = 0.0, missing = 0.0;
  while (column.time() < 6.0) {
    column.step();
    strain = std::max(strain, std::abs(at(column, -19.75).gxy));
    missing = std::max(missing, std::abs(column.energy().missing()));
  }
  const WetEnergy energy = column.energy();
  std::printf("strain %.3f, missing %.1e of the energy\n", strain, missing / energy.given());
  EXPECT_GT(strain, 0.05);
  EXPECT_LT(missing, 1e-3 * energy.given());
  EXPECT_GT(energy.plastic, 0.5 * energy.given());
}

// Free motion on a rigid base after a pulse. Central differences keep a quantity near the energy, so that the
// energy stays within a band, here 0.2 %, and does not drift.
TEST(DryHardCases, ZeroDampingForAHundredThousandSteps) {
  const Elasticity soft = Elasticity::from_wave_speeds(1700.0, 150.0, 300.0);
  const Elasticity stiff = Elasticity::from_wave_speeds(1900.0, 300.0, 600.0);
  const Profile profile{.layers = {{8.0, soft}, {12.0, stiff}}, .half_space = rock};
  const double dt = 0.99 * two_phase_step_limit(profile, 1.0, Damping{});
  TwoPhaseColumn column(profile, {.max_element_size = 1.0, .time_step = dt, .base = BaseKind::rigid},
                        [](double t) { return t < 1.0 ? ricker(0.01, 4.0, 0.5)(t) : Velocity{}; });
  while (column.time() < 1.1)
    column.step();
  const auto energy = [&] { return column.energy().kinetic + column.energy().elastic; };
  const double start = energy();
  double first = 0.0, last = 0.0; // largest departure in the first and in the last tenth
  constexpr int steps = 100000;
  for (int i = 0; i < steps; ++i) {
    column.step();
    if (i < steps / 10 || i >= steps - steps / 10) {
      double& most = i < steps / 10 ? first : last;
      most = std::max(most, std::abs(energy() / start - 1.0));
    }
  }
  std::printf("departure of the energy: %.1e at first, %.1e at last\n", first, last);
  EXPECT_LT(last, 2e-3);
  EXPECT_LT(last, 1.2 * first + 1e-9);
}

// Ten metres at 30 m/s over rock at 800 m/s, an impedance ratio of 1/39, 1 % damping: nearly all of the wave
// stays in the layer. Against the exact response.
TEST(DryHardCases, SoftLayerOverRock) {
  const Elasticity mud = Elasticity::from_wave_speeds(1500.0, 30.0, 150.0);
  constexpr double frequency = 1.5;
  const KelvinVoigtDamping damping{0.75};
  const Profile profile{.layers = {{10.0, mud, 0.01}, {10.0, rock, 0.0}}, .half_space = rock};
  const double dt = 0.5 * two_phase_step_limit(profile, 0.125, damping);
  TwoPhaseColumn column(profile, {0.125, dt, damping}, [](double t) {
    return Velocity{ricker(1.0, frequency, 1.0)(t).x, 0.0};
  });
  const auto c = coefficients(damping, 0.01);
  const LayeredColumn exact({{10.0, mud.density, mud.shear_modulus(), c.alpha, c.beta},
                             {10.0, rock.density, rock.shear_modulus(), 0.0, 0.0}},
                            rock.density * rock.s_wave_speed(), frequency, 1.0);
  std::vector<double> times;
  for (int i = 1; i <= 60; ++i) {
    times.push_back(0.1 * i);
  }
  const auto expected = exact.at(0.0, times);
  double error = 0.0;
  double peak = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    while (column.time() + column.time_step() < times[i]) {
      column.step();
    }
    const ColumnSample s = at(column, 0.0); // less than a step before the time that is asked for
    const double v = s.vx + (times[i] - column.time()) * s.vx_rate;
    error = std::max(error, std::abs(v - expected[i].velocity));
    peak = std::max(peak, std::abs(expected[i].velocity));
  }
  std::printf("error %.1e of the peak\n", error / peak);
  EXPECT_LT(error, 0.01 * peak);
}

// Nearly incompressible soil, Vp/Vs = 22: shear does not know, in hysteretic soil either.
TEST(DryHardCases, PoissonsRatioOf0p499) {
  std::vector<std::vector<double>> histories;
  for (const double poisson : {0.3, 0.499}) {
    Elasticity soil = Elasticity::from_wave_speeds(1800.0, 150.0, 300.0);
    soil = {soil.density, 2.0 * soil.shear_modulus() * (1.0 + poisson), poisson};
    const Profile profile{
        .layers = {layer_of(15.0, MasingShear{.elastic = soil, .reference_strain = 1e-3, .exponent = 0.92})},
        .half_space = rock};
    constexpr double dt = 1e-4; // below the limit at 0.499, 1.49e-4 s
    TwoPhaseColumn column(profile, {0.5, dt}, [](double t) {
      return Velocity{ricker(0.5, 2.0, 0.6)(t).x, 0.0};
    });
    auto& history = histories.emplace_back();
    while (column.time() < 2.0) {
      column.step();
      history.push_back(at(column, 0.0).vx);
    }
  }
  double difference = 0.0;
  for (std::size_t i = 0; i < histories[0].size(); ++i) {
    difference = std::max(difference, std::abs(histories[0][i] - histories[1][i]));
  }
  EXPECT_LT(difference, 1e-7);
}

} // namespace
