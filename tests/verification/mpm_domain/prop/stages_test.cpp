// Props in static stages. What linear ground does to two equal blocks on it is linear: without a prop, forces
// F that push them towards each other bring each by u_0; with a prop of stiffness k between their middles,
//
//     -N = 2 k u,      u = u_0 F/(F + 2 k u_0),
//
// since F/u_0 is the stiffness of the ground to them.

#include "mpm_domain/gravity/static_stages.hpp"
#include "tests/support/structure_scene.hpp"
#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::rectangle;
using test_support::structure;

constexpr double push = 8e3;      // F, N/m
constexpr double stiffness = 4e6; // k, N/m2
constexpr double residual = 1e-10;

/// Blocks of 3 m by 2 m, 6 m apart from middle to middle.
Spec blocks() {
  Spec spec = flat_ground(24.0, 6.0, 0.5, {2000.0, 2e7, 0.3});
  for (const double x : {-3.0, 3.0}) {
    spec.structures.push_back(structure(rectangle(x - 1.5, 0.0, x + 1.5, 2.0), 2000.0, 0.8));
    spec.structures.back().name = x < 0.0 ? "west" : "east";
    spec.structure_loads.push_back({spec.structures.back().name, {x < 0.0 ? push : -push, 0.0}});
  }
  return spec;
}

Prop strut() {
  Prop prop;
  prop.name = "strut";
  prop.from = {"west", {-3.0, 1.0}};
  prop.to = {"east", {3.0, 1.0}};
  prop.stiffness = stiffness;
  return prop;
}

/// What the east block has pushed, at the end of a stage.
struct StageEnd {
  double force = 0.0; ///< N, N/m
  double way = 0.0;   ///< of the east block's middle to the west, m
};

/// Forces come onto both blocks, each in a stage of its own.
std::vector<StaticStage> loads() {
  const StageSettings settings{.ramp = 1.0, .residual = residual, .max_time = 60.0};
  return {LoadSettings{settings, 0, true}, LoadSettings{settings, 1, true}};
}

/// A stage before which these props stand.
StaticStage change(const Spec& spec, std::vector<Prop> before) {
  return ConstructionSettings{{.ramp = 1.0, .residual = residual, .max_time = 60.0},
                              spec.regions,
                              spec.structures,
                              std::nullopt,
                              std::move(before)};
}

std::vector<StageEnd> walk(const Spec& spec, const std::vector<StaticStage>& stages) {
  Domain domain(spec);
  StaticStages through(domain, {.residual = residual}, stages, [](std::size_t, long, double) {});
  std::vector<StageEnd> ends;
  while (!through.are_over()) {
    through.next();
    through.show([&](Domain& model) {
      const RigidBody& east = model.contact.bodies()[1];
      ends.push_back(
          {model.props.any() ? model.props.all()[0].spring.force() : 0.0, east.start().x - east.centre().x});
    });
  }
  EXPECT_FALSE(through.finish().slipping);
  return ends;
}

/// u_0
double free_way() {
  return walk(blocks(), loads()).back().way;
}

/// -N of a prop that bears its part of the forces.
double part_of_prop(double u_0) {
  return 2.0 * stiffness * u_0 * push / (push + 2.0 * stiffness * u_0);
}

TEST(PropInStages, BearsItsPartOfALoadFromGravityOn) {
  const double u_0 = free_way();
  ASSERT_GT(2.0 * stiffness * u_0, 0.3 * push); // ground and prop are about as stiff
  Spec spec = blocks();
  spec.props = {strut()};
  const std::vector<StageEnd> ends = walk(spec, loads());
  EXPECT_NEAR(ends.back().force - ends.front().force, -part_of_prop(u_0), 1e-3 * push);
}

TEST(PropInStages, HasItsPrestressAndThenItsPartOfALoad) {
  constexpr double prestress = -5e3; // N/m
  const double u_0 = free_way();
  Spec spec = blocks();
  spec.props = {strut()};
  spec.props.front().prestress = prestress;
  std::vector<StaticStage> stages = loads();
  stages.insert(stages.begin(), change(spec, {}));
  const std::vector<StageEnd> ends = walk(spec, stages);
  EXPECT_EQ(ends[0].force, 0.0);
  EXPECT_DOUBLE_EQ(ends[1].force, prestress);
  EXPECT_NEAR(ends[1].way, prestress * u_0 / push, 1e-3 * u_0); // apart
  EXPECT_NEAR(ends.back().force, prestress - part_of_prop(u_0), 1e-3 * push);
}

TEST(PropInStages, HandsItsForceBackWhenItGoes) {
  Spec spec = blocks();
  Prop jacked = strut();
  jacked.prestress = -5e3;
  std::vector<StaticStage> stages{change(spec, {})}; // places it
  for (const StaticStage& load : loads())
    stages.push_back(load);
  stages.push_back(change(spec, {jacked})); // removes it
  const std::vector<StageEnd> ends = walk(spec, stages);
  const double u_0 = free_way();
  EXPECT_EQ(ends.back().force, 0.0);
  EXPECT_NEAR(ends.back().way, u_0, 1e-3 * u_0);
}

/// A block on ground that an anchor pulls down: once the anchor is gone all is as it was.
TEST(PropInStages, LeavesNoTraceInElasticGround) {
  constexpr double pull = 40e3; // N/m
  Spec spec = flat_ground(16.0, 6.0, 0.5, {2000.0, 2e7, 0.3});
  spec.structures = {structure(rectangle(-1.5, 0.0, 1.5, 2.0), 2000.0, 0.5)};
  Prop anchor;
  anchor.name = "anchor";
  anchor.from = {"block", {0.0, 1.0}};
  anchor.to = {"", {0.0, -4.0}};
  anchor.stiffness = 1e7;
  anchor.prestress = pull;
  anchor.bears = Bears::tension;
  const std::vector<StaticStage> stages{change(spec, {}), change(spec, {anchor})};
  Domain domain(spec);
  StaticStages through(domain, {.residual = residual}, stages, [](std::size_t, long, double) {});
  through.next();
  through.next();
  double down = 0.0;
  through.show([&](Domain& model) {
    EXPECT_DOUBLE_EQ(model.props.all()[0].spring.force(), pull);
    down = model.contact.bodies()[0].start().y - model.contact.bodies()[0].centre().y;
  });
  EXPECT_GT(down, 1e-3);
  through.next();
  const Reactions reactions = through.finish();
  EXPECT_NEAR(reactions.ways.front().way.y, 0.0, 1e-5 * down);
  EXPECT_NEAR(reactions.ways.front().turn, 0.0, 1e-9);
}

} // namespace
} // namespace tremolo::mpm_domain
