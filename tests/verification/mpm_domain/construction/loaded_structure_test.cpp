// A force on a structure. In elastic ground it does what the weight of a heavier structure does, it settles
// the ground as the same load does that lies on it as a pressure, and contact bears it together with the
// weight.

#include "tests/support/conservation_monitor.hpp"
#include "tests/verification/mpm_domain/construction/block_on_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::mpm_domain::test {
namespace {

using test_support::quiet_ground;
using test_support::StandingScene;

constexpr double residual = 1e-9;
constexpr Vector force{12e3, -120e3}; // N/m

Spec with_block(bool elastic) {
  Spec spec = block_on_ground();
  if (elastic)
    spec.structures.front().stiffness = Stiffness{5e8, 0.2};
  return spec;
}

Spec loaded_block(bool elastic, Vector by = force) {
  Spec spec = with_block(elastic);
  spec.structure_loads = {{"block", by}};
  return spec;
}

StaticStage load() {
  return LoadSettings{{.ramp = 2.0, .residual = residual, .max_time = 60.0}, 0, true};
}

/// Mean way of the block at the end of stages, m.
Vector way_of_block(const Spec& spec, const StaticStage& stage) {
  Domain domain(spec);
  const Reactions reactions = rest(domain, {&stage, 1}, residual);
  EXPECT_FALSE(reactions.slipping);
  if (!domain.contact.is_elastic(0))
    return reactions.ways.front().way;
  double mass = 0.0;
  Vector sum;
  for (const Particles& set : domain.sets_of_body(0))
    for (std::size_t k = 0; k < set.size(); ++k) {
      mass += set.mass[k];
      sum = {sum.x + set.mass[k] * (set.x[k] - set.x_initial[k]),
             sum.y + set.mass[k] * (set.y[k] - set.y_initial[k])};
    }
  return {sum.x / mass, sum.y / mass};
}

class LoadedStructure : public testing::TestWithParam<bool> {};

TEST_P(LoadedStructure, GoesDownAsOneDoesThatIsHeavierByTheLoad) {
  const double down = -force.y;
  const Vector loaded = way_of_block(loaded_block(GetParam(), {0.0, -down}), load());
  Spec heavier = with_block(GetParam());
  heavier.structures.front().density *= down / block_weight;
  const Vector placed = way_of_block(heavier, construction(heavier.regions, residual));
  RecordProperty("way", std::to_string(1e3 * loaded.y) + " and " + std::to_string(1e3 * placed.y) + " mm");
  EXPECT_LT(loaded.y, -1e-3);
  EXPECT_NEAR(loaded.y, placed.y, 1e-4 * std::abs(placed.y));
  EXPECT_NEAR(loaded.x, 0.0, 1e-6);
}

TEST_P(LoadedStructure, SettlesTheGroundAsAPressureDoes) {
  const Vector loaded = way_of_block(loaded_block(GetParam()), load());
  Spec bare = block_on_ground();
  bare.structures.clear();
  bare.loads = {{-1.5, 1.5, -force.y / 3.0, 0.0}};
  Domain domain(bare);
  const StaticStage pressure = LoadSettings{{.ramp = 2.0, .residual = residual, .max_time = 60.0}, 0};
  rest(domain, {&pressure, 1}, residual);
  const auto [lowest, highest] = rise_below_block(domain);
  EXPECT_GT(loaded.y, lowest);
  EXPECT_LT(loaded.y, highest);
  EXPECT_GT(loaded.x, 0.0);
}

TEST_P(LoadedStructure, IsBorneByContactWhileItStands) {
  const StaticStage stage = load();
  StandingScene scene(loaded_block(GetParam()), quiet_ground(), residual, {&stage, 1});
  scene.run(0.05);
  const BodyForces forces = scene.domain.contact.forces(0);
  const double all = block_weight - force.y;
  EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, all, 1e-5 * all);
  EXPECT_NEAR(forces.normal.force.x + forces.friction.force.x, -force.x, 1e-5 * all);
  EXPECT_NEAR(forces.weight.force.y, -all, 1e-9 * all);
  EXPECT_NEAR(forces.weight.force.x, force.x, 1e-9 * all);
  for (const Particles& set : scene.domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      EXPECT_LT(std::hypot(set.vx[k], set.vy[k]), 1e-6);
}

// The block is pushed: its load goes on doing work, which the ledger has.
TEST_P(LoadedStructure, KeepsTheLedgerClosedWhileItSwings) {
  const StaticStage stage = load();
  StandingScene scene(loaded_block(GetParam()), quiet_ground(), residual, {&stage, 1});
  test_support::set_motion(scene.domain, 0, {{0.05, -0.1}, 0.02});
  test_support::ConservationMonitor monitor(scene.domain, {.speed = 1.0});
  const double before = scene.domain.energy.static_;
  while (scene.stepper.time() < 0.3) {
    scene.stepper.step();
    monitor.after(scene.stepper);
  }
  monitor.finish();
  EXPECT_GT(std::abs(scene.domain.energy.static_ - before), 1.0);
}

INSTANTIATE_TEST_SUITE_P(RigidAndElastic, LoadedStructure, testing::Bool());

TEST(LoadedStructure, GivesWayWhereFrictionCannotHoldIt) {
  const StaticStage stage = load();
  Domain domain(loaded_block(false, {0.8 * block_weight, 0.0})); // mu = 0.5
  const Reactions reactions = rest(domain, {&stage, 1}, residual);
  EXPECT_TRUE(reactions.slipping);
}

TEST(LoadedStructure, IsRefusedWhereItDoesNotStand) {
  Spec spec = loaded_block(false);
  spec.structure_loads.front().structure = "tower";
  EXPECT_THROW(Domain{spec}, std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain::test
