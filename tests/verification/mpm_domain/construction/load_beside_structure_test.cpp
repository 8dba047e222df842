// A load on the ground beside a structure, which goes with the ground: by the settlement that the load gives
// the ground without it, weighted by the pressure under the structure.

#include "tests/support/conservation_monitor.hpp"
#include "tests/support/structure_scene.hpp"
#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain::test {
namespace {

using test_support::flat_ground;
using test_support::quiet_ground;
using test_support::rectangle;
using test_support::StandingScene;
using test_support::structure;

constexpr double residual = 1e-9;
constexpr double weight = 6.0 * 2000.0 * gravity; // N/m

/// A block of 3 by 2 m, and 40 kPa on 2 m of the ground beside it.
Spec beside_block() {
  Spec spec = flat_ground(16.0, 6.0, 0.5, {1900.0, 5e7, 0.3});
  spec.structures = {structure(rectangle(-1.5, 0.0, 1.5, 2.0), 2000.0, 0.5)};
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
  spec.cut_at_edges = true;
  Domain bare(spec);
  rest(bare, {&stage, 1}, residual);
  double least = 1.0;
  double largest = -1.0;
  const Particles& p = bare.sets.front();
  for (std::size_t k = 0; k < p.size(); ++k)
    if (std::abs(p.x[k]) < 1.5 && p.y[k] > -0.25) {
      least = std::min(least, p.y_initial[k] - p.y[k]);
      largest = std::max(largest, p.y_initial[k] - p.y[k]);
    }
  ASSERT_EQ(reactions.ways.size(), 1u);
  const StructureWay& block = reactions.ways.front();
  EXPECT_GT(-block.way.y, least);
  EXPECT_LT(-block.way.y, largest);
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
  EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, weight, 1e-5 * weight);
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
