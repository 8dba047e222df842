// A load on the ground beside a structure, which goes with the ground: by the settlement that the load gives
// the ground without it, weighted by the pressure under the structure.

#include "tests/support/conservation_monitor.hpp"
#include "tests/verification/mpm_domain/construction/block_on_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain::test {
namespace {

using test_support::quiet_ground;
using test_support::StandingScene;

constexpr double residual = 1e-9;

/// The block, and 40 kPa on 2 m of the ground beside it.
Spec beside_block() {
  Spec spec = block_on_ground();
  spec.loads = {{2.5, 4.5, 40e3, 0.0}};
  return spec;
}

StaticStage load() {
  return LoadSettings{{.ramp = 2.0, .residual = residual, .max_time = 60.0}, 0};
}

TEST(LoadBesideStructure, TakesItAlongWithTheGround) {
  const StaticStage stage = load();
  Domain with(beside_block());
  const Reactions reactions = rest(with, {&stage, 1}, residual);
  EXPECT_FALSE(reactions.slipping);
  Spec spec = beside_block();
  spec.structures.clear();
  Domain bare(spec);
  rest(bare, {&stage, 1}, residual);
  const auto [lowest, highest] = rise_below_block(bare);
  ASSERT_EQ(reactions.ways.size(), 1u);
  const StructureWay& block = reactions.ways.front();
  EXPECT_GT(block.way.y, lowest);
  EXPECT_LT(block.way.y, highest);
  EXPECT_LT(block.turn, 0.0); // it leans towards the load
}

TEST(LoadBesideStructure, StaysWhileTheGroundIsShaken) {
  const StaticStage stage = load();
  StandingScene scene(beside_block(), quiet_ground(), residual, {&stage, 1});
  test_support::ConservationMonitor monitor(scene.domain, {.speed = 1.0});
  while (scene.stepper.time() < 0.05) {
    scene.stepper.step();
    monitor.after(scene.stepper);
  }
  monitor.finish();
  const BodyForces forces = scene.domain.contact.forces(0);
  EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, block_weight, 1e-5 * block_weight);
  for (const Particles& set : scene.domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      EXPECT_LT(std::hypot(set.vx[k], set.vy[k]), 1e-6);
}

TEST(LoadBesideStructure, IsRefusedWhereTheStructureIs) {
  Spec spec = beside_block();
  spec.loads.front().x_min = 1.0;
  EXPECT_THROW(Domain{spec}, std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain::test
