// Structures that move far over quiet ground keep their contact; no particle leaves the window of its tile
// unseen; and a run that is broken off while a structure moves goes on with the same bits.

#include "tests/support/saved_state.hpp"
#include "tests/support/structure_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;
using testing::AllOf;
using testing::HasSubstr;

constexpr double h = 0.5;        // of the cells that structures meet, m
constexpr double gravity = 9.81; // m/s2
constexpr double friction = 0.1;

/// A block of two by one metres on flat ground 20 m wide, 7 m left of its middle.
Spec block_on_ground(int levels = 0) {
  Spec spec = flat_ground(20.0, 3.0, h * (1 << levels), {2000.0, 1e8, 0.2});
  if (levels > 0)
    spec.refine = {{{-10.0, -2.0, 10.0, 0.0}, levels}};
  spec.structures = {structure(rectangle(-8.0, 0.0, -6.0, 1.0), 2000.0, friction)};
  return spec;
}

/// It slides to the right until friction has taken a third of its velocity: v = v_0 - mu g t, on the ground.
void expect_to_slide(const Spec& spec) {
  constexpr double velocity = 5.0, duration = 1.7; // m/s, s
  StandingScene scene(spec);
  set_motion(scene.domain, 0, {{velocity, 0.0}, 0.0});
  scene.run(duration);
  const RigidBody& block = scene.body();
  const double slid = block.centre().x - block.start().x;
  EXPECT_NEAR(slid, velocity * duration - 0.5 * friction * gravity * duration * duration, 0.02 * slid);
  EXPECT_GT(slid, 13.0 * h);
  EXPECT_NEAR(block.motion().velocity.x, velocity - friction * gravity * duration, 0.02 * velocity);
  EXPECT_NEAR(block.centre().y, block.start().y, 0.05 * h); // gaps, and the soil that springs back
  EXPECT_NEAR(block.tilt(), 0.0, 0.01);
}

TEST(MovingBlock, SlidesFarOnTheGround) {
  expect_to_slide(block_on_ground());
}

TEST(MovingBlock, SlidesFarOnRefinedGround) {
  expect_to_slide(block_on_ground(1));
}

TEST(MovingBlock, SlidesFarIfItIsElastic) {
  Spec spec = block_on_ground();
  spec.structures.front().stiffness = Stiffness{1e8, 0.2};
  expect_to_slide(spec);
}

std::string failure_of(Stepper& stepper, int steps) {
  try {
    for (int step = 0; step < steps; ++step)
      stepper.step();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(MovingBlock, IsStoppedWhereItComesToCoarserCells) {
  Spec spec = block_on_ground(1);
  spec.refine.front().box.x_max = 0.0;
  StandingScene scene(spec);
  set_motion(scene.domain, 0, {{5.0, 0.0}, 0.0});
  const std::string said = failure_of(scene.stepper, 4000);
  EXPECT_THAT(said, AllOf(HasSubstr("structure 'block' has come within a cell of soil on cells larger"),
                          HasSubstr("step ")));
  EXPECT_LT(scene.body().surface().bounds().x_max, 0.0);
}

TEST(MovingBlock, IsStoppedWhereItLeavesTheModel) {
  StandingScene scene(block_on_ground());
  set_motion(scene.domain, 0, {{-20.0, 5.0}, 0.0});
  EXPECT_THAT(failure_of(scene.stepper, 4000), HasSubstr("structure 'block' has left the model"));
}

bool touches(const Domain& domain) {
  return std::ranges::any_of(domain.contact.nodes(0), &ContactNode::tied);
}

/// Breaks a run off after some time and goes on with it, for as long again.
/// @returns whether the block touched the ground then, and at the end
std::pair<bool, bool> go_on_with_the_same_bits(const RigidMotion& motion, double duration) {
  const Spec spec = block_on_ground();
  StandingScene whole(spec);
  set_motion(whole.domain, 0, motion);
  whole.run(duration);
  const bool touched = touches(whole.domain);
  const SavedState saved = saved_state(whole.domain, whole.stepper);
  StandingScene resumed(spec);
  restore_state(saved, resumed.domain, resumed.stepper);
  whole.run(duration);
  resumed.run(duration);
  expect_same(saved_state(whole.domain, whole.stepper), saved_state(resumed.domain, resumed.stepper));
  return {touched, touches(whole.domain)};
}

TEST(MovingBlock, GoesOnWithTheSameBitsInTheMiddleOfItsWay) {
  EXPECT_EQ(go_on_with_the_same_bits({{5.0, 0.0}, 0.0}, 0.4), std::pair(true, true));
}

/// It flies for 0.82 s and lands on the whole of its base.
TEST(MovingBlock, GoesOnWithTheSameBitsInTheMiddleOfItsFlight) {
  EXPECT_EQ(go_on_with_the_same_bits({{2.0, 4.0}, 0.0}, 0.45), std::pair(false, true));
}

/// Both tie themselves to the nodes between them, which are light and pass on little of what one does to the
/// other.
TEST(TwoBlocks, LessThanACellApartComeToRest) {
  for (const double of_second : {0.0, 0.8}) {
    Spec spec = flat_ground(16.0, 4.0, h, {2000.0, 4.8e8, 1.0 / 3.0});
    spec.structures = {structure(rectangle(-3.5, 0.0, -1.5, 2.0), 2000.0, 0.8),
                       structure(rectangle(-1.2, 0.0, 0.8, 2.0), 1000.0, of_second)};
    Domain domain(spec);
    Reactions reactions;
    ASSERT_NO_THROW(
        reactions = relax_under_gravity(domain, {.residual = 1e-8, .max_time = 5.0}, [](long, double) {}));
    EXPECT_FALSE(reactions.slipping);
  }
}

/// What an error elsewhere might do to a particle between two steps.
struct Displaced {
  double x, y; ///< m
};

class StrayParticles : public testing::TestWithParam<Displaced> {};

TEST_P(StrayParticles, EndTheRunWithTheirNames) {
  for (const int levels : {0, 1}) {
    Spec spec = block_on_ground(levels);
    spec.structures.clear();
    Domain domain(spec);
    Stepper stepper(domain, 0.0, quiet_ground());
    for (int step = 0; step < 3; ++step)
      stepper.step();
    Particles& p = domain.sets.front();
    const std::size_t k = p.size() / 2;
    p.x[k] += (1 << levels) * GetParam().x;
    p.y[k] += (1 << levels) * GetParam().y;
    const std::string name = "particle " + std::to_string(p.id[k]) + " of soil 'soil' at x = ";
    EXPECT_THAT(failure_of(stepper, 1), AllOf(HasSubstr(name), HasSubstr("step 3"))) << levels << " levels";
  }
}

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
INSTANTIATE_TEST_SUITE_P(Places, StrayParticles,
                         testing::Values(Displaced{40 * h, 0.0}, Displaced{-40 * h, 0.0},
                                         Displaced{0.0, 20 * h}, Displaced{0.0, -20 * h},
                                         Displaced{36 * h, -h}, Displaced{1e12, 0.0}, Displaced{0.0, -1e12},
                                         Displaced{nowhere, 0.0}, Displaced{0.0, nowhere},
                                         Displaced{nowhere, nowhere}));

} // namespace
} // namespace tremolo::mpm_domain
