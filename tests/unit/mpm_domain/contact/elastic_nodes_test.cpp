// What contact promises at a node of soil and one of an elastic body, over random states: momentum, common
// normal velocity, the loss of energy in closed form, no labels, and an end after one solution.

#include "random_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tremolo::mpm_domain {
namespace {

using test::Draw;
using test::random_node;
using test::Totals;

/// A node of soil with one of an elastic body, after contact.
struct Pair {
  ContactNode node;
  Vector solid, water, body;

  explicit Pair(ContactNode c) : node(std::move(c)) {
    node.solve_alone(false);
    const auto changed = [](const Vector& v, const Vector& by) { return Vector{v.x + by.x, v.y + by.y}; };
    solid = changed(node.solid_trial, node.solid_change);
    water = changed(node.water_trial, node.water_change);
    body = changed(node.body_trial, node.body_change);
  }
};

ContactNode random_pair(Draw& draw, bool wet, double least_mass, double most_mass) {
  ContactNode c = random_node(draw, wet, least_mass, most_mass);
  c.body_mass = draw.decades(least_mass, most_mass);
  c.body_trial = draw.vector();
  c.set_trial({});
  return c;
}

class ElasticNode : public testing::TestWithParam<bool> {};

TEST_P(ElasticNode, KeepsMomentumAndTakesOneNormalVelocity) {
  Draw draw(11);
  int tied = 0;
  for (int k = 0; k < 100000; ++k) {
    const Pair pair(random_pair(draw, GetParam(), 1e-9, 1e3));
    const ContactNode& c = pair.node;
    Totals before, after;
    before.add(c.solid_mass, c.solid_trial, c.arm);
    before.add(c.water_mass, c.water_trial, c.arm);
    before.add(c.body_mass, c.body_trial, c.arm);
    after.add(c.solid_mass, pair.solid, c.arm);
    after.add(c.water_mass, pair.water, c.arm);
    after.add(c.body_mass, pair.body, c.arm);
    ASSERT_NEAR(after.x, before.x, 4e-15 * before.mass);
    ASSERT_NEAR(after.y, before.y, 4e-15 * before.mass);
    ASSERT_NEAR(after.turn, before.turn, 2e-14 * before.mass);
    ASSERT_LE(std::abs(c.tangential_impulse), c.bound(c.effective_impulse) * (1.0 + 1e-12));
    if (!c.tied)
      continue;
    ++tied;
    // Rounding of the heavier's momentum moves the lighter.
    const double ratio = std::max({1.0, c.mass / c.body_mass, c.body_mass / c.mass});
    ASSERT_NEAR(dot(c.normal, pair.solid), dot(c.normal, pair.body), 1e-14 * ratio);
    const double of_water = dot(c.normal, GetParam() ? pair.water : pair.solid);
    ASSERT_NEAR(of_water, dot(c.normal, pair.body), 1e-14 * ratio);
  }
  EXPECT_GT(tied, 30000);
}

INSTANTIATE_TEST_SUITE_P(DryAndWet, ElasticNode, testing::Bool());

/// dE = -1/2 sum m (v.n - V_n)^2 - T (2 T_st - T)/(2 m_sb), with T_st = m_sb |relative tangential velocity|.
TEST(DryElasticNode, LosesTheEnergyOfItsClosedForm) {
  Draw draw(12);
  for (int k = 0; k < 100000; ++k) {
    const Pair pair(random_pair(draw, false, 1e-4, 1e3));
    const ContactNode& c = pair.node;
    const double ms = c.solid_mass;
    const double mb = c.body_mass;
    const Vector v = c.solid_trial;
    const Vector u = c.body_trial;
    const double change = 0.5 * ms * (dot(pair.solid, pair.solid) - dot(v, v)) +
                          0.5 * mb * (dot(pair.body, pair.body) - dot(u, u));
    double exact = 0.0;
    if (dot(c.normal, v) > dot(c.normal, u)) {
      const double common = (ms * dot(c.normal, v) + mb * dot(c.normal, u)) / (ms + mb);
      const double normal = ms * (dot(c.normal, v) - common);
      const double reduced = ms * mb / (ms + mb);
      const double stick = reduced * std::abs(dot(c.tangent(), v) - dot(c.tangent(), u));
      const double t = std::min(stick, c.friction * normal);
      exact = -0.5 * ms * std::pow(dot(c.normal, v) - common, 2) -
              0.5 * mb * std::pow(dot(c.normal, u) - common, 2) - t * (2.0 * stick - t) / (2.0 * reduced);
    }
    ASSERT_NEAR(change, exact, 1e-14 * (ms + mb));
  }
}

/// A node that its body has only just reached has next to no mass, and its forces throw it. What it passes on
/// is its own momentum.
TEST(DryElasticNode, PassesOnNoMoreThanAnAllButEmptyNodeHas) {
  ContactNode c;
  c.normal = {1.0, 0.0};
  c.solid_mass = c.mass = c.tangential = 475.0;
  c.body_mass = 5e-18;
  c.solid_trial = c.water_trial = {-3.1e-9, 2.3e-10};
  c.body_trial = {-1.6e8, 3e7};
  c.friction = 0.4;
  c.set_trial({});
  const Pair pair(c);
  EXPECT_NEAR(pair.node.normal_impulse, 5e-18 * 1.6e8, 1e-12 * 8e-10);
  EXPECT_NEAR(pair.solid.x, c.solid_trial.x, 1e-11);
  EXPECT_NEAR(pair.solid.y, c.solid_trial.y, 1e-11);
  EXPECT_NEAR(pair.body.x, pair.solid.x, 1e-7); // the rounding of its trial velocity
}

/// Labels of soil and body change positions: the same motion. A second contact changes nothing.
TEST(DryElasticNode, KnowsNoLabelsAndIsDoneAtOnce) {
  Draw draw(13);
  for (int k = 0; k < 100000; ++k) {
    const Pair pair(random_pair(draw, false, 1e-3, 1e3));
    ContactNode other = pair.node;
    other.tied = true;
    other.slip = 0;
    other.solid_mass = other.mass = other.tangential = pair.node.body_mass;
    other.body_mass = pair.node.solid_mass;
    other.solid_trial = other.water_trial = pair.node.body_trial;
    other.body_trial = pair.node.solid_trial;
    other.normal = {-pair.node.normal.x, -pair.node.normal.y};
    other.set_trial({});
    const Pair swapped(other);
    ASSERT_NEAR(swapped.solid.x, pair.body.x, 1e-8);
    ASSERT_NEAR(swapped.solid.y, pair.body.y, 1e-8);
    ASSERT_NEAR(swapped.body.x, pair.solid.x, 1e-8);
    ASSERT_NEAR(swapped.body.y, pair.solid.y, 1e-8);
    ContactNode again = pair.node;
    again.solid_trial = again.water_trial = pair.solid;
    again.body_trial = pair.body;
    again.set_trial({});
    if (pair.node.slip != 0)
      continue; // it slides on: without N there is no friction
    const Pair done(again);
    ASSERT_NEAR(done.solid.x, pair.solid.x, 1e-8);
    ASSERT_NEAR(done.body.y, pair.body.y, 1e-8);
  }
}

} // namespace
} // namespace tremolo::mpm_domain
