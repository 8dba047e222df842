// Shaking, then rest: the sand of run B3E of tests/support/liquefying_column.hpp, 10 m, D_r = 55 %, k = 1e-3
// m/s, shaken for 15 s. PM4Sand reconsolidates with its elastic stiffness times F_sed, and F_sed acts only on
// the pressure that is left when the rest begins: the earlier the rest, the more the ground settles.

#include "freefield/marched/marched_column.hpp"
#include "tests/support/liquefying_column.hpp"

#include <gtest/gtest.h>

namespace tremolo::freefield::testing {
namespace {

LiquefyingSand sand_until(double end) {
  return pm4sand_column("B3E", 0.55, 677.0, 0.40, 1e-3, end);
}

struct Rest {
  double from;       ///< s
  double settlement; ///< at 99.5 s, mm
};

/// The values are those of an earlier driver that changed the law of the same column in mid-run. That
/// driver's column settled by 15.7 mm without a rest; over what it settles without one, what a rest adds does
/// not depend on how the shaking was damped.
void expect_settlements(const std::vector<Rest>& rests) {
  const auto settlement = [](const materials::SoilClock& clock) {
    return computed(sand_until(99.5), 0.5, 2e-4, clock).settlement_at(99.5);
  };
  const double without = settlement({});
  for (const Rest& rest : rests)
    EXPECT_NEAR(settlement(rest_from(rest.from)) / without / (rest.settlement / 15.7), 1.0, 0.03)
        << "rest from " << rest.from << " s on";
}

TEST(RestOfSand, SettlesByWhenItBegins) {
  expect_settlements({{15.0, 39.1}});
}

TEST(AcceptanceRestOfSand, SettlesByWhenItBegins) {
  expect_settlements({{17.0, 30.1}, {25.0, 17.5}});
}

template <class Column, class Settings>
void expect_no_kick(const Settings& shaken, double rest_from) {
  const Profile profile = liquefying_profile(sand_until(rest_from));
  Settings rested = shaken;
  rested.clock = testing::rest_from(rest_from);
  Column a(profile, shaken, BaseShaking(0.981)), b(profile, rested, BaseShaking(0.981));
  constexpr std::array levels = {-9.0, -5.0, -2.0};
  std::array<ColumnSample, levels.size()> of_a, of_b;
  const auto until = [&](double time) {
    while (a.time() < time) {
      a.step();
      b.step();
    }
    a.sample(levels, of_a);
    b.sample(levels, of_b);
  };
  until(rest_from);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    EXPECT_EQ(of_a[i].pore_pressure, of_b[i].pore_pressure) << levels[i];
    EXPECT_EQ(of_a[i].uy, of_b[i].uy) << levels[i];
  }
  until(rest_from + 0.5 * shaken.time_step); // one step further
  for (std::size_t i = 0; i < levels.size(); ++i) {
    EXPECT_NEAR(of_b[i].syy, of_a[i].syy, 20.0) << levels[i];
    EXPECT_NEAR(of_b[i].sxy, of_a[i].sxy, 20.0) << levels[i];
    EXPECT_NEAR(of_b[i].pore_pressure, of_a[i].pore_pressure, 20.0) << levels[i];
  }
  until(rest_from + 2.0); // softer soil drains more slowly
  EXPECT_GT(of_b[1].pore_pressure, of_a[1].pore_pressure);
}

/// Stress and pressure, some 50 kPa, move in the first step of the rest by no more than 20 Pa beside those
/// of the same column without it.
TEST(RestOfSandBegins, WithoutAKick) {
  expect_no_kick<TwoPhaseColumn>(liquefying_settings(0.5, 2e-4), 15.0);
}

TEST(RestOfSandBegins, WithoutAKickInTheColumnForAnyAngle) {
  expect_no_kick<MarchedColumn>(MarchedSettings{.max_element_size = 0.5,
                                                .time_step = 2e-4,
                                                .damping = KelvinVoigtDamping{5.0},
                                                .base = BaseKind::rigid},
                                15.0);
}

/// When the first 1-s mean of r_u at a depth is above 0.7 after a time, s after it; infinite where never.
double time_to_liquefy(const LiquefactionHistory& history, std::size_t depth, double start) {
  for (double time = start + 0.5; time < start + 15.0; time += 0.5)
    if (history.mean(depth, time - 0.5, time + 0.5) > 0.7)
      return time - start;
  return std::numeric_limits<double>::infinity();
}

/// The base shakes again at 40 s, when r_u at 5 m is below 0.01. Sand remembers: it liquefies in half of the
/// time, which a fresh column would not, and settles by as much again.
TEST(Aftershock, MeetsSandThatRemembers) {
  const LiquefactionHistory history = computed(sand_until(60.0), 0.5, 2e-4, {}, {40.0});
  EXPECT_LT(history.ratio_at(2, 40.0), 0.01);
  const double main = time_to_liquefy(history, 2, 0.0);
  EXPECT_NEAR(time_to_liquefy(history, 2, 40.0) / main, 0.5, 0.2);
  // An earlier driver of the same column found 15.7 mm and 30.2 mm.
  EXPECT_NEAR(history.settlement_at(59.5) / history.settlement_at(39.5), 30.2 / 15.7, 0.06);
}

/// A rest of two steps leaves no trace: shaken sand has its stiffness again. With that of the rest to the end
/// it settles by more.
/// @param aftershocks  s
/// @param more         times as much, at least
void expect_stiffness_of_shaking(double end, const std::vector<double>& aftershocks, double more) {
  const auto settlement = [&](const materials::SoilClock& clock) {
    return computed(sand_until(end), 0.5, 2e-4, clock, aftershocks).settlement_at(end - 0.5);
  };
  const double shaken = settlement({});
  EXPECT_NEAR(settlement(materials::SoilClock({{15.0}, {4e-4, 1.0}, {end}})) / shaken, 1.0, 0.02);
  EXPECT_GT(settlement(rest_from(15.0)) / shaken, more);
}

TEST(ShortRestOfSand, LeavesTheStiffnessOfShaking) {
  expect_stiffness_of_shaking(25.0, {}, 1.2); // measured: 1.26
}

TEST(AcceptanceAftershock, FindsTheStiffnessOfShaking) {
  expect_stiffness_of_shaking(60.0, {40.0}, 1.5);
}

/// A rest from 20 s on.
struct FastRest {
  double factor;
  double settlement;     ///< largest error over the settlement that the rest adds, 1
  double pressure_ratio; ///< largest error of r_u from 5 to 50 s of the rest, 1
};

/// Over time of the soil, every 1 s until `end`, s: settlement, and r_u at the depths.
std::vector<std::array<double, 1 + depths.size()>> resting_sand(double factor, double end) {
  const LiquefyingSand sand = pm4sand_column("B2", 0.55, 677.0, 0.40, 1e-4, end);
  const Profile profile = liquefying_profile(sand);
  TwoPhaseSettings settings = liquefying_settings(0.5, 2e-4);
  settings.clock = rest_from(20.0, factor);
  TwoPhaseColumn column(profile, settings, BaseShaking(0.981));
  const double weight = materials::buoyant_density(*profile.layers[0].pores, {}) * 9.81;
  std::vector<double> levels = {0.0};
  for (const double depth : depths)
    levels.push_back(-depth);
  std::vector<ColumnSample> samples(levels.size());
  std::vector<std::array<double, 1 + depths.size()>> rows;
  for (double time = 20.0; time <= end; time += 1.0) {
    while (column.time() < settings.clock.simulated_time(time) - 0.5 * settings.time_step)
      column.step();
    column.sample(levels, samples);
    auto& row = rows.emplace_back();
    row[0] = -samples[0].uy;
    for (std::size_t i = 0; i < depths.size(); ++i)
      row[i + 1] = samples[i + 1].pore_pressure / (weight * depths[i]);
  }
  return rows;
}

/// PM4Sand scatters by 0.1 to 0.6 % of the settlement with any factor, for the slightest change of its path.
void expect_the_end_of_the_slow_one(double end, const std::vector<FastRest>& rests) {
  const auto slow = resting_sand(1.0, end);
  const double added = slow.back()[0] - slow.front()[0];
  for (const FastRest& fast : rests) {
    const auto rows = resting_sand(fast.factor, end);
    double settlement = 0.0, ratio = 0.0;
    for (std::size_t t = 0; t < rows.size(); ++t) {
      settlement = std::max(settlement, std::abs(rows[t][0] - slow[t][0]) / added);
      for (std::size_t i = 1; t >= 5 && t <= 50 && i < rows[t].size(); ++i)
        ratio = std::max(ratio, std::abs(rows[t][i] - slow[t][i]));
    }
    EXPECT_LT(settlement, fast.settlement) << "factor " << fast.factor;
    EXPECT_LT(ratio, fast.pressure_ratio) << "factor " << fast.factor;
  }
}

TEST(FastRestOfSand, EndsWhereTheSlowOneDoes) {
  expect_the_end_of_the_slow_one(120.0, {{30.0, 0.008, 0.002}});
}

TEST(AcceptanceFastRestOfSand, EndsWhereTheSlowOneDoes) {
  expect_the_end_of_the_slow_one(400.0, {{30.0, 0.008, 0.002}, {100.0, 0.008, 0.005}});
}

} // namespace
} // namespace tremolo::freefield::testing
