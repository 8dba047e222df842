// The vertical column of finite elements in ground without water: its energy, what it serves, its step, its
// start and what it refuses.

#include "freefield/twophase/two_phase_column.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;
using tremolo::materials::MohrCoulomb;

const Elasticity soft = Elasticity::from_wave_speeds(1700.0, 150.0, 320.0);
const Elasticity stiff = Elasticity::from_wave_speeds(1900.0, 300.0, 560.0);
const Elasticity rock = Elasticity::from_wave_speeds(2200.0, 800.0, 1500.0);
const KelvinVoigtDamping damping{3.0};

Profile two_layers(double ratio) {
  return {0.0, {{8.0, soft, ratio}, {22.0, stiff, ratio}}, rock};
}

/// Hysteretic soil over linear soil, gravity on.
Profile hysteretic_profile() {
  const MasingShear hysteretic{.elastic = soft, .reference_strain = 5e-4, .exponent = 0.92};
  return {0.0, {layer_of(8.0, hysteretic, 0.01), {22.0, stiff, 0.02}}, rock, 9.81};
}

Velocity pulse(double t) {
  const double a = std::pow(std::numbers::pi * 3.0 * (t - 0.5), 2);
  const double v = 0.3 * (1.0 - 2.0 * a) * std::exp(-a);
  return {v, 0.4 * v};
}

/// The pulse is so weak that elements hardly change their length, which closed forms keep.
Velocity weak_pulse(double t) {
  const auto [x, y] = pulse(t);
  return {1e-6 * x, 1e-6 * y};
}

ColumnSample at(const Column& column, double y) {
  ColumnSample sample;
  column.sample({&y, 1}, {&sample, 1});
  return sample;
}

void run_until(Column& column, double time) {
  while (column.time() < time - 0.5 * column.time_step())
    column.step();
}

/// The largest share of the energy given so far that is missing, of the largest given, over 3 s.
double missing_share(const Profile& profile, const TwoPhaseSettings& settings) {
  TwoPhaseColumn column(profile, settings, pulse);
  double missing = 0.0, given = 0.0;
  while (column.time() < 3.0) {
    column.step();
    missing = std::max(missing, std::abs(column.energy().missing()));
    given = std::max(given, column.energy().given());
  }
  EXPECT_GT(column.energy().damping, 0.0);
  return missing / given;
}

TEST(DryColumnEnergy, BalancesWorkStoredAndDissipatedEnergyToSecondOrder) {
  for (const Profile& profile : {two_layers(0.03), hysteretic_profile()})
    for (const BaseKind base : {BaseKind::compliant, BaseKind::rigid}) {
      const auto share = [&](double dt) {
        return missing_share(
            profile,
            {.max_element_size = 1.0, .time_step = dt, .damping = RayleighDamping{1.0, 6.0}, .base = base});
      };
      const double coarse = share(2e-4), fine = share(1e-4);
      EXPECT_LT(coarse, 1e-4);
      EXPECT_TRUE(fine < 1e-9 || std::log2(coarse / fine) > 1.8) << coarse << " " << fine;
    }
}

TEST(DryColumnEnergy, RadiationAndDampingEmptyTheColumn) {
  TwoPhaseColumn column(two_layers(0.03), {1.0, 2e-4, damping}, weak_pulse);
  run_until(column, 0.6);
  const double during = column.energy().kinetic + column.energy().elastic;
  run_until(column, 8.0);
  EXPECT_LT(column.energy().kinetic + column.energy().elastic, 1e-6 * during);
}

// The half-space continued to the surface: the incident wave arrives after H/c and is doubled there; a level
// z below sees up- and downgoing waves, stress is their difference times the impedance.
TEST(DryColumn, OfTheBasesOwnSoilShowsTheTwoDelayedPulses) {
  const double height = 40.0, depth = 12.3;
  TwoPhaseColumn column({0.0, {{height, soft, 0.0}}, soft}, {0.1, 2.5e-4, damping}, pulse);
  const double cs = soft.s_wave_speed(), cp = soft.p_wave_speed();
  for (const double time : {0.55, 0.7, 0.78, 0.9, 1.1}) {
    run_until(column, time);
    const ColumnSample surface = at(column, 0.0), below = at(column, -depth);
    EXPECT_NEAR(surface.vx, 2.0 * pulse(time - height / cs).x, 1e-3);
    EXPECT_NEAR(surface.vy, 2.0 * pulse(time - height / cp).y, 1e-3);
    const double up_x = pulse(time - (height - depth) / cs).x;
    const double down_x = pulse(time - (height + depth) / cs).x;
    EXPECT_NEAR(below.vx, up_x + down_x, 1e-3);
    EXPECT_NEAR(below.sxy, -soft.density * cs * (up_x - down_x), 1e-3 * soft.density * cs);
    const double up_y = pulse(time - (height - depth) / cp).y;
    const double down_y = pulse(time - (height + depth) / cp).y;
    const double syy = -soft.density * cp * (up_y - down_y);
    EXPECT_NEAR(below.syy, syy, 1e-3 * soft.density * cp);
    EXPECT_NEAR(below.sxx, soft.rest_coefficient() * syy, 1e-3 * soft.density * cp);
  }
}

TEST(DryColumn, StressVanishesAtTheSurfaceIsContinuousAndMeetsTheDashpot) {
  for (const Damping& kind : {Damping(damping), Damping(RayleighDamping{1.0, 6.0})}) {
    TwoPhaseColumn column(two_layers(0.03), {1.0, 2e-4, kind}, weak_pulse);
    const double impedance = rock.density * rock.s_wave_speed();
    double peak = 0.0, at_surface = 0.0, jump = 0.0, at_base = 0.0;
    for (int i = 1; i <= 30; ++i) {
      run_until(column, 0.05 * i);
      const double dashpot = impedance * (at(column, -30.0).vx - 2.0 * weak_pulse(column.time()).x);
      peak = std::max(peak, std::abs(dashpot));
      at_surface = std::max({at_surface, std::abs(at(column, 0.0).sxy), std::abs(at(column, 0.0).syy)});
      at_base = std::max(at_base, std::abs(at(column, -30.0).sxy - dashpot));
      for (const double node : {-8.0, -5.0, -20.0})
        jump = std::max(jump, std::abs(at(column, node + 1e-9).sxy - at(column, node - 1e-9).sxy));
    }
    EXPECT_LT(at_surface, 1e-9 * peak);
    EXPECT_LT(at_base, 1e-9 * peak);
    EXPECT_LT(jump, 1e-8 * peak);
  }
}

TEST(DryColumn, RatesAreTheTimeDerivatives) {
  const double dt = 1e-4;
  TwoPhaseColumn column(two_layers(0.03), {1.0, dt, damping}, pulse);
  constexpr std::array<double, 4> levels = {0.0, -6.3, -8.0, -25.0};
  std::vector<std::array<ColumnSample, 4>> history;
  while (column.time() < 1.2) {
    column.step();
    column.sample(levels, history.emplace_back());
  }
  using Member = double ColumnSample::*;
  constexpr std::array<std::pair<Member, Member>, 5> pairs = {
      {{&ColumnSample::vx, &ColumnSample::vx_rate},
       {&ColumnSample::vy, &ColumnSample::vy_rate},
       {&ColumnSample::sxx, &ColumnSample::sxx_rate},
       {&ColumnSample::syy, &ColumnSample::syy_rate},
       {&ColumnSample::sxy, &ColumnSample::sxy_rate}}};
  for (std::size_t q = 0; q < pairs.size(); ++q) {
    const auto [value, rate] = pairs[q];
    double error = 0.0, peak = 0.0;
    for (std::size_t i = 1; i + 1 < history.size(); ++i)
      for (std::size_t level = 0; level < levels.size(); ++level) {
        const double difference = (history[i + 1][level].*value - history[i - 1][level].*value) / (2.0 * dt);
        error = std::max(error, std::abs(history[i][level].*rate - difference));
        peak = std::max(peak, std::abs(difference));
      }
    EXPECT_LT(error, 1e-3 * peak) << q;
  }
}

TEST(DryColumn, ServesBothLimitsAtAnInterface) {
  TwoPhaseColumn column(two_layers(0.0), {0.5, 4e-4}, pulse);
  run_until(column, 0.62);
  constexpr std::array<double, 5> asked = {-8.0 - 1e-7, -8.0, -8.0, -8.0 + 1e-7, 0.0};
  std::array<ColumnSample, 5> s;
  column.sample(asked, s);
  const double peak = std::abs(s[1].sxx) + std::abs(s[2].sxx);
  EXPECT_GT(std::abs(s[1].sxx - s[2].sxx), 0.01 * peak);
  for (const std::size_t lower : {std::size_t{0}, std::size_t{2}}) {
    EXPECT_NEAR(s[lower].sxx, s[lower + 1].sxx, 1e-5 * peak);
    EXPECT_NEAR(s[lower].gxy, s[lower + 1].gxy, 1e-5 * std::abs(s[lower].gxy));
    EXPECT_NEAR(s[lower].eyy, s[lower + 1].eyy, 1e-5 * std::abs(s[lower].eyy));
  }
  EXPECT_NEAR(s[1].syy, s[2].syy, 1e-9 * peak);
  EXPECT_NEAR(s[1].sxx / s[1].syy, stiff.rest_coefficient(), 1e-9);
  EXPECT_NEAR(s[2].sxx / s[2].syy, soft.rest_coefficient(), 1e-9);
  EXPECT_EQ(at(column, -8.0).sxx, s[2].sxx);
}

TEST(StepLimit, IsElementCrossingTimeWithoutDamping) {
  EXPECT_NEAR(two_phase_step_limit(two_layers(0.0), 1.0, damping), 1.0 / stiff.p_wave_speed(), 1e-15);
}

// dt (dt + 2 beta) w^2 = 4 with w = 2 c/h is where the root z = -1 of the scheme lies, whose damping is that
// of half a step ago.
TEST(StepLimit, ShrinksWithStiffnessProportionalDamping) {
  const Profile profile{0.0, {{10.0, soft, 0.05}}, rock};
  const double limit = two_phase_step_limit(profile, 0.5, damping);
  const double beta = 2.0 * 0.05 / (2.0 * std::numbers::pi * 3.0);
  const double w = 2.0 * soft.p_wave_speed() / 0.5;
  EXPECT_NEAR(limit * (limit + 2.0 * beta) * w * w, 4.0, 1e-10);
}

TEST(StepLimit, JustBelowItTheColumnIsStable) {
  for (const double ratio : {0.0, 0.01, 0.2}) {
    const Profile profile = two_layers(ratio);
    const double dt = 0.999 * two_phase_step_limit(profile, 2.0, damping);
    TwoPhaseColumn column(profile, {2.0, dt, damping}, weak_pulse);
    run_until(column, 1.0);
    const double during = column.energy().kinetic + column.energy().elastic;
    run_until(column, 12.0);
    EXPECT_LT(column.energy().kinetic + column.energy().elastic, 1e-4 * during) << ratio;
  }
}

constexpr double degree = std::numbers::pi / 180.0;

Profile sand_profile(double friction_deg, double rest_coefficient) {
  Layer layer = layer_of(10.0, MohrCoulomb{.elastic = soft,
                                           .friction_peak = friction_deg * degree,
                                           .friction_residual = friction_deg * degree});
  layer.soil.at_rest = rest_coefficient;
  return {0.0, {layer}, rock, 9.81};
}

TEST(GeostaticStress, LeavesTheColumnAtRest) {
  TwoPhaseColumn column(sand_profile(30.0, 0.5), {.max_element_size = 0.5, .time_step = 1e-3},
                        [](double) { return Velocity{}; });
  run_until(column, 1.0);
  for (const double y : {-10.0, -4.0, 0.0}) {
    const ColumnSample s = at(column, y);
    for (const double value : {s.vx, s.vy, s.ux, s.uy, s.eyy, s.gxy})
      EXPECT_LT(std::abs(value), 1e-12);
  }
}

TEST(GeostaticStress, BeyondTheStrengthIsRefusedWithThePlace) {
  EXPECT_THAT(
      [] { TwoPhaseColumn(sand_profile(30.0, 0.2), {.max_element_size = 1.0, .time_step = 1e-3}, pulse); },
      ::testing::ThrowsMessage<std::invalid_argument>(
          ::testing::AllOf(::testing::HasSubstr("layer 1 from the top: at a depth of"),
                           ::testing::HasSubstr("beyond the soil's strength"))));
}

// A layer of dry sand on a rigid base whose acceleration grows slowly: the shear stress is the acceleration
// over g times the vertical stress at every depth, so the whole layer yields at once,
//     a_1/g = sqrt((1 + K0)^2 sin^2(phi) - (1 - K0)^2) / 2,
// and where the soil flows without dilation the ratio is sin(phi), the limit of drained simple shear.
TEST(DrySand, YieldsAndFlowsAtTheAccelerationsOfSimpleShear) {
  const double sine = std::sin(30.0 * degree);
  const double first_yield = 9.81 * 0.5 * std::sqrt(1.5 * 1.5 * sine * sine - 0.25);
  const double rise = 2.0; // m/s3
  TwoPhaseColumn column(sand_profile(30.0, 0.5),
                        {.max_element_size = 1.0,
                         .time_step = 1e-3,
                         .damping = RayleighDamping{3.0, 9.0},
                         .base = BaseKind::rigid},
                        [=](double t) {
                          return Velocity{0.5 * rise * t * t, 0.0};
                        });
  const double vertical = soft.density * 9.81 * 5.5;
  double largest = 0.0, yield_acceleration = 0.0;
  while (column.time() < 4.5) {
    column.step();
    largest = std::max(largest, std::abs(at(column, -5.5).sxy) / vertical);
    if (yield_acceleration == 0.0 && column.energy().plastic > 0.0)
      yield_acceleration = rise * column.time();
  }
  std::printf("yield at %.4f of the closed form, flow at %.4f\n", yield_acceleration / first_yield,
              largest / sine);
  EXPECT_NEAR(yield_acceleration, first_yield, 0.05 * first_yield);
  EXPECT_NEAR(largest, sine, 0.02 * sine);
}

void expect_refused(const TwoPhaseSettings& settings, const std::string& words) {
  EXPECT_THAT([&] { TwoPhaseColumn(two_layers(0.03), settings, pulse); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr(words)));
}

TEST(TwoPhaseSettings, AreRefusedWithTheValueAndTheAllowedRange) {
  expect_refused({1.0, 1e-2, damping}, "stability limit of central differences");
  expect_refused({1.0, 0.0, damping}, "time step of the column is 0, must be positive");
  expect_refused({0.0, 1e-3, damping}, "largest element size is 0");
  expect_refused({1.0, 1e-4, KelvinVoigtDamping{}}, "reference frequency of Kelvin-Voigt damping is 0");
}

TEST(DryColumn, RefusesToSampleOutsideItself) {
  const TwoPhaseColumn column(two_layers(0.0), {1.0, 1e-3}, pulse);
  EXPECT_THROW(at(column, 0.01), std::invalid_argument);
  EXPECT_THROW(at(column, -30.01), std::invalid_argument);
}

TEST(DryColumn, StopsAtAnIncidentMotionThatIsNotANumber) {
  TwoPhaseColumn column(two_layers(0.0), {1.0, 1e-3}, [](double t) {
    return Velocity{t > 0.1 ? std::numeric_limits<double>::quiet_NaN() : 0.0, 0.0};
  });
  EXPECT_THROW(run_until(column, 0.2), std::runtime_error);
}

TEST(DryColumn, TimeIsCountedFromTheStartTime) {
  TwoPhaseColumn column(two_layers(0.0), {.max_element_size = 1.0, .time_step = 1e-3, .start_time = -2.0},
                        pulse);
  column.step();
  EXPECT_DOUBLE_EQ(column.time(), -2.0 + 1e-3);
  EXPECT_DOUBLE_EQ(column.base_level(), -30.0);
  EXPECT_DOUBLE_EQ(column.surface_level(), 0.0);
}

} // namespace
