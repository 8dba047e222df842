// Rigid blocks on rigid blocks: at rest the lowest bears on the soil with the weight of all, they go down
// under a load as one block of their outline does, and they stay where they are when the ground is released.

#include "tests/verification/mpm_domain/construction/stages.hpp"

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::rectangle;
using test_support::structure;

constexpr double density = 1500.0; // kg/m3
constexpr double weight = 3.0 * 3.0 * density * 9.81;

/// A stack of 3 m by 3 m: a footing, and on it a narrower block and a wide one; or one block of the same
/// mass.
/// @param stem  half the width of the narrower one, m: up to that of the others, so that corners coincide
Spec stack(bool whole, double stem = 0.75) {
  Spec spec = flat_ground(18.0, 6.0, 0.5, {2000.0, 2e7, 0.3});
  const auto add = [&](const char* name, double half, double bottom, double top) {
    spec.structures.push_back(structure(rectangle(-half, bottom, half, top), density * 1.5 / half, 0.6));
    spec.structures.back().name = name;
  };
  if (whole) {
    add("block", 1.5, 0.0, 3.0);
    return spec;
  }
  add("footing", 1.5, 0.0, 1.0);
  add("stem", stem, 1.0, 2.0);
  add("head", 1.5, 2.0, 3.0);
  return spec;
}

/// With these halves of the width of the block in the middle, m.
class StackedBlocksOf : public testing::TestWithParam<double> {};

TEST_P(StackedBlocksOf, BearOnTheSoilWithTheWeightOfAll) {
  test_support::StandingScene scene(stack(false, GetParam()), test_support::quiet_ground(), 1e-10);
  EXPECT_FALSE(scene.reactions.slipping);
  std::vector<Vector> before;
  for (const RigidBody& body : scene.domain.contact.bodies())
    before.push_back(body.centre());
  for (int k = 0; k < 5; ++k) {
    scene.run(0.1);
    const BodyForces forces = scene.domain.contact.forces(0);
    EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, weight, 1e-4 * weight);
  }
  for (std::size_t b = 0; b < before.size(); ++b) {
    EXPECT_NEAR(scene.body(b).centre().x, before[b].x, 1e-6);
    EXPECT_NEAR(scene.body(b).centre().y, before[b].y, 1e-6);
    EXPECT_NEAR(scene.body(b).tilt(), 0.0, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, StackedBlocksOf, testing::Values(0.75, 1.5));

TEST(StackedBlocks, GoDownUnderALoadAsOneBlock) {
  std::vector<double> down;
  for (const bool whole : {true, false}) {
    Spec spec = stack(whole);
    spec.structure_loads = {{spec.structures.back().name, {4e3, -60e3}}};
    const std::vector<StaticStage> stages{
        LoadSettings{{.ramp = 1.0, .residual = 1e-10, .max_time = 60.0}, 0, true}};
    Domain domain(spec);
    const Reactions reactions = test::rest(domain, stages, 1e-10);
    EXPECT_FALSE(reactions.slipping);
    for (const StructureWay& structure : reactions.ways)
      down.push_back(-structure.way.y);
  }
  ASSERT_EQ(down.size(), 4U);
  EXPECT_GT(down[0], 1e-3);
  for (const double one : down)
    EXPECT_NEAR(one, down[0], 1e-4 * down[0]);
}

/// The head is pulled aside by 0.3 of its weight.
/// @param rows  friction between the blocks, and half the width of the one in the middle, m
void expect_sliding(std::initializer_list<std::pair<double, double>> rows) {
  for (const auto& [friction, stem] : rows) {
    Spec spec = stack(false, stem);
    spec.soils.front().law = materials::LinearElastic{{2000.0, 2e9, 0.3}}; // the footing hardly turns
    for (Structure& one : spec.structures)
      one.friction_between = friction;
    const double pull = 0.3 * density * 3.0 * 9.81;
    spec.structure_loads = {{"head", {pull, 0.0}, Growth{0.0, 0.01}}};
    test_support::StandingScene scene(spec, test_support::quiet_ground(), 1e-10);
    scene.run(0.3);
    const double way = scene.body(2).centre().x - scene.body(1).centre().x;
    if (friction > 0.3)
      EXPECT_NEAR(way, 0.0, 1e-4);
    else
      EXPECT_NEAR(way, 0.5 * 9.81 * (0.3 - friction) * 0.09, 0.05 * 0.5 * 9.81 * 0.05 * 0.09);
  }
}

TEST(StackedBlocks, SlideOffWhatIsTooSmooth) {
  expect_sliding({{0.25, 1.5}, {0.35, 0.75}});
}

TEST(AcceptanceStackedBlocks, SlideOffWhatIsTooSmooth) {
  expect_sliding({{0.25, 0.75}, {0.35, 1.5}});
}

} // namespace
} // namespace tremolo::mpm_domain
