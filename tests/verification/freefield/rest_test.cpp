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

class RestOfSand : public ::testing::TestWithParam<Rest> {};

/// The values are those of an earlier driver that changed the law of the same column in mid-run. Without a
/// rest it settles by 15.7 mm.
TEST_P(RestOfSand, SettlesByWhenItBegins) {
  const auto history = computed(sand_until(99.5), 0.5, 2e-4, GetParam().from);
  EXPECT_NEAR(1e3 * history.settlement_at(99.5) / GetParam().settlement, 1.0, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Rest, RestOfSand,
                         ::testing::Values(Rest{15.0, 39.1}, Rest{17.0, 30.1}, Rest{25.0, 17.5}),
                         [](const auto& one) {
                           return "From" + std::to_string(static_cast<int>(one.param.from)) + "Seconds";
                         });

template <class Column, class Settings>
void expect_no_kick(const Settings& shaken, double rest_from) {
  const Profile profile = liquefying_profile(sand_until(rest_from));
  Settings rested = shaken;
  rested.rest_from = rest_from;
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

} // namespace
} // namespace tremolo::freefield::testing
