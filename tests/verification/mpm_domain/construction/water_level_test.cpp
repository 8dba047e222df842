// The water falls under level sand of height H and modulus M, slowly or fast.
//
// Slowly, a table at the surface that falls by d leaves dry soil, which weighs (1 - n) gamma_w more than
// under water:
//
//     d sigma'_v = (1 - n) gamma_w d below the new table, and grows from 0 to that above it,
//     settlement = (1 - n) gamma_w d (H - d + d/2)/M.
//
// Free water that falls takes its load from grains and water alike; where water cannot flow, its pressure
// falls by Q/(M + Q) of the load, Q = K_f/n, and the grains keep their stress but for M/(M + Q) of it.

#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace tremolo::mpm_domain::test {
namespace {

constexpr double height = 10.0;
constexpr double width = 1.0;
constexpr double fall = 4.0; // d
constexpr double porosity = 0.388;
constexpr double bulk = 2.0e8;
constexpr double residual = 1e-9;
constexpr double unit_weight = 1000.0 * gravity; // gamma_w

Spec sand_under(double level, materials::Drainage drainage = materials::Drainage::coupled) {
  Spec spec = level_ground(width, height, 0.0, 0.5);
  spec.water = {level, {.density = 1000.0, .bulk_modulus = bulk}};
  spec.soils.front().pores = {
      .porosity = porosity, .grain_density = 2650.0, .permeability = 1e-3, .drainage = drainage};
  return spec;
}

/// Water that falls to the level of the spec.
StaticStage falls_from(double level, Spec& spec, bool undrained) {
  GroundWater before = *spec.water;
  before.level = level;
  if (undrained)
    spec.water->still_wet = level;
  return construction(spec.regions, residual, 2.0, undrained, {}, before);
}

double settlement_of_surface(const Domain& domain) {
  double uppermost = -1e9;
  double settled = 0.0;
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      if (p.y[k] > uppermost) {
        uppermost = p.y[k];
        settled = p.y_initial[k] - p.y[k];
      }
  return settled;
}

TEST(WaterLevel, ThatFallsSlowlyLoadsTheSandBelow) {
  Spec spec = sand_under(-fall);
  const StaticStage stage = falls_from(0.0, spec, false);
  Domain domain(spec);
  rest(domain, {&stage, 1}, residual);
  const double heavier = (1.0 - porosity) * unit_weight * fall;
  EXPECT_NEAR(settlement_of_surface(domain), heavier * (height - 0.5 * fall) / modulus, 0.005 * 9.6e-3);
  const double dry = (1.0 - porosity) * 2650.0 * gravity;
  const double buoyant = (1.0 - porosity) * (2650.0 - 1000.0) * gravity;
  std::map<int, std::vector<double>> cells; // what weighs more anew strains particles of one cell alike
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      cells[static_cast<int>(std::floor(p.y[k] / 0.5))].push_back(p.syy[k]);
      if (p.traits.wet) {
        EXPECT_NEAR(excess_pressure(p, k), 0.0, 1e-6);
      }
    }
  for (const auto& [number, stresses] : cells) {
    const double y = 0.5 * (number + 0.5);
    const double exact = y > -fall ? dry * y : -dry * fall + buoyant * (y + fall);
    const double mean =
        std::accumulate(stresses.begin(), stresses.end(), 0.0) / static_cast<double>(stresses.size());
    EXPECT_NEAR(mean, exact, 1e-6 * dry * height) << "y = " << y;
  }
}

// The ground keeps its water and with it everything else.
TEST(WaterLevel, ThatFallsFastLeavesTheGroundAsItIs) {
  Spec spec = sand_under(-fall);
  const StaticStage stage = falls_from(0.0, spec, true);
  Domain domain(spec);
  rest(domain, {&stage, 1}, residual);
  EXPECT_NEAR(settlement_of_surface(domain), 0.0, 1e-8);
  const double buoyant = (1.0 - porosity) * (2650.0 - 1000.0) * gravity;
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      ASSERT_TRUE(p.traits.wet);
      EXPECT_NEAR(p.pore_pressure[k], -unit_weight * p.y[k], 1e-6 * unit_weight * height);
      EXPECT_NEAR(p.syy[k], buoyant * p.y[k], 1e-6 * buoyant * height);
    }
}

class FreeWater : public testing::TestWithParam<materials::Drainage> {};

TEST_P(FreeWater, ThatFallsFastTakesTheLoadOffTheWater) {
  Spec spec = sand_under(0.0, GetParam());
  const StaticStage stage = falls_from(fall, spec, true);
  Domain domain(spec);
  rest(domain, {&stage, 1}, residual);
  const double share = bulk / porosity / (modulus + bulk / porosity);
  const double buoyant = (1.0 - porosity) * (2650.0 - 1000.0) * gravity;
  const double load = unit_weight * fall;
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      EXPECT_NEAR((p.pore_pressure[k] - unit_weight * (fall - p.y[k])) / load, -share, 1e-3);
      EXPECT_NEAR((p.syy[k] - buoyant * p.y[k]) / load, 1.0 - share, 1e-3);
    }
}

TEST_P(FreeWater, ThatFallsSlowlyChangesNoEffectiveStress) {
  Spec spec = sand_under(0.0, GetParam());
  const StaticStage stage = falls_from(fall, spec, false);
  Domain domain(spec);
  rest(domain, {&stage, 1}, residual);
  EXPECT_NEAR(settlement_of_surface(domain), 0.0, 1e-8);
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      EXPECT_NEAR(p.pore_pressure[k], -unit_weight * p.y[k], 1e-6 * unit_weight * height);
}

INSTANTIATE_TEST_SUITE_P(Drainage, FreeWater,
                         testing::Values(materials::Drainage::coupled, materials::Drainage::undrained));

// Free water leaves a slope faster than the slope drains: what is undisturbed then has no pressure on the
// surface that has come out of it, and rests there.
TEST(WaterLevel, ThatFallsFastBesideASlopeLeavesItFullOfWater) {
  Spec spec = sand_under(0.5);
  spec.soils.front().pores->permeability = 1e-7; // nothing flows off in a step
  spec.box = {0.0, -4.0, 16.0, 2.0};
  spec.sides = Sides::free_field;
  spec.regions = {{0, {{0.0, -4.0}, {16.0, -4.0}, {16.0, 0.0}, {10.0, 0.0}, {6.0, 2.0}, {0.0, 2.0}}}};
  const StaticStage stage = falls_from(3.0, spec, true);
  Domain domain(spec);
  replace_constraints(domain, rest(domain, {&stage, 1}, residual));
  ASSERT_TRUE(domain.head);
  EXPECT_NEAR(domain.head->at(3.0, 1.0).head, 2.0, 1e-9);    // along the shelf
  EXPECT_NEAR(domain.head->at(8.25, 0.5).head, 0.875, 1e-9); // along the slope
  EXPECT_NEAR(domain.head->at(14.0, -1.0).head, 0.5, 1e-9);  // free water
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      ASSERT_TRUE(p.traits.wet);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  stepper.step();
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      EXPECT_LT(std::hypot(p.vx[k], p.vy[k]), 1e-6);
}

// A table that rises again lifts the soil by what its fall has let it settle.
TEST(WaterLevel, ThatComesBackFindsTheGroundWhereItWas) {
  Spec spec = sand_under(0.0);
  GroundWater low = *spec.water;
  low.level = -fall;
  const std::vector<StaticStage> stages{construction(spec.regions, residual, 2.0, false, {}, spec.water),
                                        construction(spec.regions, residual, 2.0, false, {}, low)};
  Domain domain(spec);
  rest(domain, stages, residual);
  EXPECT_NEAR(settlement_of_surface(domain), 0.0, 1e-6);
}

} // namespace
} // namespace tremolo::mpm_domain::test
