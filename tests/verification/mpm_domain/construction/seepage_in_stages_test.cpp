// Water that begins to seep in a stage, through ground that a later stage changes: each model has the flow of
// its own ground, and rests under it.

#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/head/seepage_of_ground.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tremolo::mpm_domain::test {
namespace {

constexpr double residual = 1e-8;

/// What is cut from the foot of the bank.
Region foot() {
  return {0, {{16.0, -1.0}, {24.0, -1.0}, {24.0, 0.0}, {16.0, 0.0}}};
}

/// A slope of 1:2 between a shelf at y = 4 m and what is left of the one at y = 0.
Spec cut_bank() {
  Spec spec = test_support::elastic_box(24.0, 4.0, 1.0);
  spec.box.y_max = 4.0;
  spec.gravity = gravity;
  spec.soils.front().pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-4};
  spec.soils.front().law =
      materials::LinearElastic{{materials::saturated_density(*spec.soils.front().pores, {}), 50e6, 0.3}};
  spec.regions = {
      {0, {{0.0, -4.0}, {24.0, -4.0}, {24.0, -1.0}, {16.0, -1.0}, {16.0, 0.0}, {8.0, 4.0}, {0.0, 4.0}}}};
  spec.water = {3.0, {}};
  spec.water->seepage = {3.0, -1.0};
  return spec;
}

TEST(SeepageInStages, IsThatOfTheGroundOfEachStage) {
  const Spec spec = cut_bank();
  GroundWater before = *spec.water; // a table, then a flow to the level of the foot
  before.seepage.reset();
  before.level = -1.0;
  GroundWater flow = *spec.water;
  flow.seepage = {3.0, -0.5};
  std::vector<Region> whole = spec.regions;
  whole.push_back(foot());
  const std::vector<StaticStage> stages{construction(whole, residual, 2.0, false, {}, before),
                                        construction(whole, residual, 2.0, false, {}, flow)};
  Domain domain(spec);
  replace_constraints(domain, rest(domain, stages, residual));
  const SeepageOfGround alone = seep(spec);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  while (stepper.time() < 0.05)
    stepper.step();
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      EXPECT_LT(std::hypot(p.vx[k], p.vy[k]), 1e-6);
      if (!p.traits.wet)
        continue;
      EXPECT_NEAR(p.head[k], alone.head.at(p.x[k], p.y[k]).head, 1e-6);
      EXPECT_NEAR(excess_pressure(p, k), 0.0, 2.0);
    }
}

} // namespace
} // namespace tremolo::mpm_domain::test
