// The marched column: what it refuses, the impedance of its base, its limit at s -> 0, rigid bases, energy.

#include "freefield/marched/marched_column.hpp"
#include "freefield/twophase/two_phase_column.hpp"
#include "tests/support/oblique_march.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace tremolo::freefield;
using namespace tremolo::freefield::testing;
using ::testing::HasSubstr;
using tremolo::materials::Drainage;
using tremolo::materials::DruckerPrager;

const PlaneWave small_pulse{15.0, true, [](double t) { return ricker(t, 5.0, 0.4, 1e-3); }};

TEST(BaseImpedance, HasTheNumbersOfTheSpecification) {
  const double s = std::sin(15.0 * degree) / 760.0;
  const BaseImpedance base = base_impedance(rock(), s);
  EXPECT_NEAR(base.outgoing(0, 0), 1648730.63, 0.01);
  EXPECT_NEAR(base.outgoing(1, 1), 3337380.27, 0.01);
  EXPECT_NEAR(base.outgoing(1, 0), 49923.527, 0.001);
  EXPECT_DOUBLE_EQ(base.outgoing(0, 1), -base.outgoing(1, 0));
  EXPECT_DOUBLE_EQ(base.incident(0, 0), 2.0 * base.outgoing(0, 0));
  EXPECT_DOUBLE_EQ(base.incident(1, 1), 2.0 * base.outgoing(1, 1));
}

TEST(BaseImpedance, IsThatOfDashpotsAtVerticalIncidence) {
  const BaseImpedance base = base_impedance(rock(), 0.0);
  EXPECT_DOUBLE_EQ(base.outgoing(0, 0), 2400.0 * rock().s_wave_speed());
  EXPECT_DOUBLE_EQ(base.outgoing(1, 1), 2400.0 * rock().p_wave_speed());
  EXPECT_EQ(base.outgoing(0, 1), 0.0);
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

TEST(MarchedColumn, RefusesACriticalWaveNamingTheLayer) {
  const Profile ground = wet_ground(); // c_1 = 2,040 m/s: critical from 21.9 degrees on rock of 760 m/s
  const PlaneWave wave{22.5, true, small_pulse.velocity};
  const std::string message = refusal([&] { marched(ground, wave, 1.0, 0.001); });
  EXPECT_THAT(message, HasSubstr("critical in layer"));
  EXPECT_THAT(message, HasSubstr("1/c_1"));
  EXPECT_EQ(refusal([&] { marched(ground, {21.5, true, small_pulse.velocity}, 1.0, 0.001); }), "nothing");
}

TEST(MarchedColumn, RefusesAStepOverItsLimit) {
  const double s = small_pulse.slowness(rock());
  const double limit = marched_step_limit(dry_ground(), 1.0, s, {});
  const auto column = [&](double dt) {
    return [&, dt] {
      MarchedColumn(dry_ground(), {.max_element_size = 1.0, .time_step = dt, .slowness_x = s},
                    small_pulse.input());
    };
  };
  EXPECT_THAT(refusal(column(1.001 * limit)), HasSubstr("stability limit"));
  EXPECT_EQ(refusal(column(0.999 * limit)), "nothing");
}

/// Both columns march the same equations at s = 0. The marched one gives velocities at whole levels, the
/// two-phase column means of two half levels.
TEST(MarchedColumn, AtVerticalIncidenceIsTheTwoPhaseColumn) {
  const InputVelocity input = [](double t) {
    return Velocity{ricker(t, 5.0, 0.4, 1e-3), ricker(t, 4.0, 0.5, 5e-4)};
  };
  constexpr double dt = 2e-4;
  MarchedColumn marched(wet_ground(), {.max_element_size = 1.0, .time_step = dt}, input);
  TwoPhaseColumn two_phase(wet_ground(), {.max_element_size = 1.0, .time_step = dt}, input);
  constexpr std::array<double, 4> centres = {0.5, 7.5, 12.5, 19.5};
  std::array<ColumnSample, centres.size()> a, b;
  double velocity = 0.0, stress = 0.0, peak_velocity = 0.0, peak_stress = 0.0;
  while (marched.time() < 1.2) {
    marched.step();
    two_phase.step();
    marched.sample(centres, a);
    two_phase.sample(centres, b);
    for (std::size_t k = 0; k < centres.size(); ++k) {
      velocity = std::max({velocity, std::abs(a[k].vx - b[k].vx), std::abs(a[k].vy - b[k].vy)});
      peak_velocity = std::max({peak_velocity, std::abs(b[k].vx), std::abs(b[k].vy)});
      for (const auto component :
           {&ColumnSample::sxx, &ColumnSample::syy, &ColumnSample::sxy, &ColumnSample::pore_pressure}) {
        stress = std::max(stress, std::abs(a[k].*component - b[k].*component));
        peak_stress = std::max(peak_stress, std::abs(b[k].*component));
      }
    }
  }
  EXPECT_LT(velocity, 2e-5 * peak_velocity);
  EXPECT_LT(stress, 1e-8 * peak_stress);
}

TEST(MarchedColumn, BalancesItsEnergyToSecondOrderInTheStep) {
  Profile ground = wet_ground();
  for (Layer& layer : ground.layers) {
    const DruckerPrager law{.elastic = layer.soil, .cohesion = 15e3, .friction = 25.0 * degree};
    layer.law = law;
  }
  const PlaneWave wave{15.0, true, [](double t) { return ricker(t, 3.0, 0.5, 0.3); }};
  const auto missing = [&](double dt) {
    MarchedColumn column(
        ground, {.max_element_size = 1.0, .time_step = dt, .slowness_x = wave.slowness(ground.half_space)},
        wave.input());
    march_to(column, 1.5);
    const WetEnergy energy = column.energy();
    std::printf("dt %.1e: given %.4g, plastic %.4g, drag %.4g, missing %.3g J/m2; %s\n", dt, energy.given(),
                energy.plastic, energy.drag, energy.missing(), column.report().c_str());
    EXPECT_GT(energy.plastic, 0.05 * energy.given()) << "the case does not yield";
    return std::abs(energy.missing()) / energy.given();
  };
  const double coarse = missing(3e-4), fine = missing(1.5e-4);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_LT(fine, coarse);
}

/// What a step leaves unconverged is owed to the laws and does not add up: one call of them a step gives the
/// motion that many give.
TEST(MarchedColumn, OneCallOfTheLawsAStepIsEnough) {
  const PlaneWave wave{15.0, true, [](double t) { return ricker(t, 3.0, 0.5, 0.3); }};
  for (Profile ground : {dry_ground(), wet_ground()}) {
    ground.gravity = 9.81;
    for (Layer& layer : ground.layers) {
      layer.soil.at_rest = 0.7;
      layer.law = DruckerPrager{.elastic = layer.soil, .cohesion = 15e3, .friction = 25.0 * degree};
    }
    const auto march = [&](double tolerance) {
      MarchedColumn column(ground,
                           {.max_element_size = 1.0,
                            .time_step = 3e-4,
                            .slowness_x = wave.slowness(ground.half_space),
                            .tolerance = tolerance},
                           wave.input());
      std::vector<ColumnSample> history;
      while (column.time() < 1.5) {
        column.step();
        column.sample(std::array{20.0}, std::span(&history.emplace_back(), 1));
      }
      return std::pair(history, column.evaluations_per_step());
    };
    const auto [few, calls] = march(MarchedSettings().tolerance);
    const auto [many, many_calls] = march(1e-10);
    RelativeError vx, vy;
    for (std::size_t i = 0; i < few.size(); ++i) {
      vx.add(few[i].vx, many[i].vx);
      vy.add(few[i].vy, many[i].vy);
    }
    std::printf("%.2f and %.2f calls a step: vx differs by %.1e, vy by %.1e\n", calls, many_calls, vx.value(),
                vy.value());
    EXPECT_LT(calls, 1.2);
    EXPECT_GT(many_calls, 1.9);
    EXPECT_LT(vx.value(), 1e-5);
    EXPECT_LT(vy.value(), 1e-5);
  }
}

TEST(MarchedColumn, ARigidBaseMovesAsPrescribed) {
  const double s = small_pulse.slowness(rock());
  MarchedColumn column(wet_ground(),
                       {.max_element_size = 1.0, .time_step = 2e-4, .slowness_x = s, .base = BaseKind::rigid},
                       small_pulse.input());
  std::array<ColumnSample, 1> base;
  double worst = 0.0;
  while (column.time() < 1.0) {
    column.step();
    column.sample(std::array{0.0}, base);
    worst = std::max(worst, std::abs(base[0].vy - small_pulse.input()(column.time()).y));
  }
  EXPECT_LT(worst, 1e-12);
  const WetEnergy energy = column.energy();
  EXPECT_LT(std::abs(energy.missing()), 2e-3 * energy.base);
}

} // namespace
