#include "freefield/fe/fe_column.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;

const Elasticity soft = Elasticity::from_wave_speeds(1700.0, 150.0, 320.0);
const Elasticity stiff = Elasticity::from_wave_speeds(1900.0, 300.0, 560.0);
const Elasticity rock = Elasticity::from_wave_speeds(2200.0, 800.0, 1500.0);
const KelvinVoigtDamping damping{3.0};

Profile two_layers(double ratio) {
  return {0.0, {{8.0, soft, ratio}, {22.0, stiff, ratio}}, rock};
}

Velocity pulse(double t) {
  const double a = std::pow(std::numbers::pi * 3.0 * (t - 0.5), 2);
  const double v = (1.0 - 2.0 * a) * std::exp(-a);
  return {v, 0.4 * v};
}

ColumnSample at(const Column& column, double y) {
  ColumnSample sample;
  column.sample({&y, 1}, {&sample, 1});
  return sample;
}

void run_until(Column& column, double time) {
  while (column.time() < time - 0.5 * column.time_step()) {
    column.step();
  }
}

/// Largest imbalance of energy over 3 s, relative to the largest energy in the column.
double energy_imbalance(Integrator integrator, double dt, const Damping& kind) {
  FeColumn column(two_layers(0.03), {1.0, dt, integrator, kind}, pulse);
  double imbalance = 0.0;
  double largest = 0.0;
  while (column.time() < 3.0) {
    column.step();
    const ColumnEnergy e = column.energy();
    imbalance = std::max(imbalance, std::abs(e.base_work - e.kinetic - e.strain - e.damping));
    largest = std::max(largest, e.kinetic + e.strain);
    EXPECT_GE(e.damping, 0.0);
  }
  return imbalance / largest;
}

TEST(FeColumnEnergy, NewmarkBalancesWorkStoredAndDissipatedEnergyToRounding) {
  EXPECT_LT(energy_imbalance(Integrator::newmark, 2e-3, damping), 1e-11);
  EXPECT_LT(energy_imbalance(Integrator::newmark, 2e-3, RayleighDamping{1.0, 6.0}), 1e-11);
}

TEST(FeColumnEnergy, CentralDifferencesBalanceToSecondOrder) {
  const RayleighDamping rayleigh{1.0, 6.0};
  const double coarse = energy_imbalance(Integrator::central_difference, 2e-4, rayleigh);
  const double fine = energy_imbalance(Integrator::central_difference, 1e-4, rayleigh);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_GT(std::log2(coarse / fine), 1.9);
}

TEST(FeColumnEnergy, RadiationAndDampingEmptyTheColumn) {
  FeColumn column(two_layers(0.03), {1.0, 2e-3, Integrator::newmark, damping}, pulse);
  run_until(column, 0.6);
  const double during = column.energy().kinetic + column.energy().strain;
  run_until(column, 8.0);
  EXPECT_LT(column.energy().kinetic + column.energy().strain, 1e-6 * during);
}

// The half-space continued to the surface: the incident wave arrives after H/c and is doubled there; a level
// z below sees up- and downgoing waves, stress is their difference times the impedance.
TEST(FeColumn, OfTheBasesOwnSoilShowsTheTwoDelayedPulses) {
  const double height = 40.0;
  const double depth = 12.3;
  FeColumn column({0.0, {{height, soft, 0.0}}, soft}, {0.1, 2.5e-4, Integrator::newmark, damping}, pulse);
  const double cs = soft.s_wave_speed();
  const double cp = soft.p_wave_speed();
  for (const double time : {0.55, 0.7, 0.78, 0.9, 1.1}) {
    run_until(column, time);
    const ColumnSample surface = at(column, 0.0);
    EXPECT_NEAR(surface.vx, 2.0 * pulse(time - height / cs).x, 2e-3);
    EXPECT_NEAR(surface.vy, 2.0 * pulse(time - height / cp).y, 2e-3);
    const ColumnSample below = at(column, -depth);
    const double up_x = pulse(time - (height - depth) / cs).x;
    const double down_x = pulse(time - (height + depth) / cs).x;
    EXPECT_NEAR(below.vx, up_x + down_x, 2e-3);
    EXPECT_NEAR(below.sxy, -soft.density * cs * (up_x - down_x), 2e-3 * soft.density * cs);
    const double up_y = pulse(time - (height - depth) / cp).y;
    const double down_y = pulse(time - (height + depth) / cp).y;
    const double syy = -soft.density * cp * (up_y - down_y);
    EXPECT_NEAR(below.syy, syy, 2e-3 * soft.density * cp);
    EXPECT_NEAR(below.sxx, soft.rest_coefficient() * syy, 2e-3 * soft.density * cp);
  }
}

class EitherIntegrator : public ::testing::TestWithParam<Integrator> {};

TEST_P(EitherIntegrator, StressVanishesAtTheSurfaceIsContinuousAndMeetsTheDashpot) {
  for (const Damping kind : {Damping(damping), Damping(RayleighDamping{1.0, 6.0})}) {
    FeColumn column(two_layers(0.03), {1.0, 2e-4, GetParam(), kind}, pulse);
    const double impedance = rock.density * rock.s_wave_speed();
    double peak = 0.0;
    double at_surface = 0.0;
    double jump = 0.0;
    double at_base = 0.0;
    for (int i = 1; i <= 30; ++i) {
      run_until(column, 0.05 * i);
      const double dashpot = impedance * (at(column, -30.0).vx - 2.0 * pulse(column.time()).x);
      peak = std::max(peak, std::abs(dashpot));
      at_surface = std::max({at_surface, std::abs(at(column, 0.0).sxy), std::abs(at(column, 0.0).syy)});
      at_base = std::max(at_base, std::abs(at(column, -30.0).sxy - dashpot));
      for (const double node : {-8.0, -5.0, -20.0}) {
        jump = std::max(jump, std::abs(at(column, node + 1e-9).sxy - at(column, node - 1e-9).sxy));
      }
    }
    EXPECT_LT(at_surface, 1e-9 * peak);
    EXPECT_LT(at_base, 1e-9 * peak);
    EXPECT_LT(jump, 1e-8 * peak);
  }
}

TEST_P(EitherIntegrator, RatesAreTheTimeDerivatives) {
  const double dt = 1e-4;
  FeColumn column(two_layers(0.03), {1.0, dt, GetParam(), damping}, pulse);
  constexpr std::array<double, 4> levels = {0.0, -6.3, -8.0, -25.0};
  std::vector<std::array<ColumnSample, 4>> history;
  while (column.time() < 1.2) {
    column.step();
    column.sample(levels, history.emplace_back());
  }
  struct Pair {
    const char* name;
    double ColumnSample::*value;
    double ColumnSample::*rate;
  };
  for (const Pair& q : {Pair{"vx", &ColumnSample::vx, &ColumnSample::vx_rate},
                        Pair{"vy", &ColumnSample::vy, &ColumnSample::vy_rate},
                        Pair{"sxx", &ColumnSample::sxx, &ColumnSample::sxx_rate},
                        Pair{"syy", &ColumnSample::syy, &ColumnSample::syy_rate},
                        Pair{"sxy", &ColumnSample::sxy, &ColumnSample::sxy_rate}}) {
    double error = 0.0;
    double peak = 0.0;
    for (std::size_t i = 1; i + 1 < history.size(); ++i) {
      for (std::size_t level = 0; level < levels.size(); ++level) {
        const double difference =
            (history[i + 1][level].*q.value - history[i - 1][level].*q.value) / (2.0 * dt);
        error = std::max(error, std::abs(history[i][level].*q.rate - difference));
        peak = std::max(peak, std::abs(difference));
      }
    }
    EXPECT_LT(error, 1e-3 * peak) << q.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Both, EitherIntegrator,
                         ::testing::Values(Integrator::newmark, Integrator::central_difference));

TEST(CentralDifferenceLimit, IsElementCrossingTimeWithoutDamping) {
  const Profile profile = two_layers(0.0);
  EXPECT_NEAR(central_difference_limit(profile, 1.0, damping), 1.0 / stiff.p_wave_speed(), 1e-15);
}

// dt (dt + 4 beta) w^2 = 4 with w = 2 c/h is where the root z = -1 of the scheme lies.
TEST(CentralDifferenceLimit, ShrinksWithStiffnessProportionalDamping) {
  const Profile profile{0.0, {{10.0, soft, 0.05}}, rock};
  const double limit = central_difference_limit(profile, 0.5, damping);
  const double beta = 2.0 * 0.05 / (2.0 * std::numbers::pi * 3.0);
  const double w = 2.0 * soft.p_wave_speed() / 0.5;
  EXPECT_NEAR(limit * (limit + 4.0 * beta) * w * w, 4.0, 1e-10);
}

TEST(CentralDifferenceLimit, JustBelowItTheColumnIsStable) {
  for (const double ratio : {0.0, 0.01, 0.2}) {
    const Profile profile = two_layers(ratio);
    const double dt = 0.999 * central_difference_limit(profile, 2.0, damping);
    FeColumn column(profile, {2.0, dt, Integrator::central_difference, damping}, pulse);
    run_until(column, 1.0);
    const double during = column.energy().kinetic + column.energy().strain;
    run_until(column, 12.0);
    EXPECT_LT(column.energy().kinetic + column.energy().strain, 1e-4 * during) << ratio;
  }
}

void expect_refused(const FeColumnSettings& settings, const std::string& words) {
  EXPECT_THAT([&] { FeColumn(two_layers(0.03), settings, pulse); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr(words)));
}

TEST(FeColumnSettings, AreRefusedWithTheValueAndTheAllowedRange) {
  expect_refused({1.0, 1e-2, Integrator::central_difference, damping},
                 "stability limit of central differences");
  expect_refused({1.0, 0.0, Integrator::newmark, damping}, "time step of the column is 0, must be positive");
  expect_refused({0.0, 1e-3, Integrator::newmark, damping}, "largest element size is 0");
  expect_refused({1.0, 1e-3, Integrator::newmark, KelvinVoigtDamping{}},
                 "reference frequency of Kelvin-Voigt damping is 0");
}

TEST(FeColumn, RefusesToSampleOutsideItself) {
  const FeColumn column(two_layers(0.0), {1.0, 1e-3, Integrator::newmark, damping}, pulse);
  EXPECT_THROW(at(column, 0.01), std::invalid_argument);
  EXPECT_THROW(at(column, -30.01), std::invalid_argument);
}

TEST(FeColumn, StopsAtAnIncidentMotionThatIsNotANumber) {
  const auto broken = [](double t) {
    return Velocity{t > 0.1 ? std::numeric_limits<double>::quiet_NaN() : 0.0, 0.0};
  };
  FeColumn column(two_layers(0.0), {1.0, 1e-2, Integrator::newmark, damping}, broken);
  EXPECT_THROW(run_until(column, 0.2), std::runtime_error);
}

TEST(FeColumn, TimeIsCountedFromTheStartTime) {
  FeColumn column(two_layers(0.0), {1.0, 1e-3, Integrator::newmark, damping, -2.0}, pulse);
  column.step();
  EXPECT_DOUBLE_EQ(column.time(), -2.0 + 1e-3);
  EXPECT_DOUBLE_EQ(column.base_level(), -30.0);
  EXPECT_DOUBLE_EQ(column.surface_level(), 0.0);
}

} // namespace
