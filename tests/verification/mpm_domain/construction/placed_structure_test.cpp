// Structures that are placed on ground at rest, or removed from it. In elastic soil the stress does not
// depend on when they came; what depends on it is how far the ground has moved with them.

#include "tests/verification/mpm_domain/construction/block_on_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain::test {
namespace {

using test_support::quiet_ground;
using test_support::StandingScene;

constexpr double residual = 1e-9;

Spec with_block(bool elastic) {
  Spec spec = block_on_ground();
  if (elastic)
    spec.structures.front().stiffness = Stiffness{5e8, 0.2};
  return spec;
}

double largest_difference_of_stress(const Domain& a, const Domain& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.sets.front().size(); ++k)
    largest = std::max({largest, std::abs(a.sets.front().syy[k] - b.sets.front().syy[k]),
                        std::abs(a.sets.front().sxx[k] - b.sets.front().sxx[k])});
  return largest;
}

class PlacedStructure : public testing::TestWithParam<bool> {};

TEST_P(PlacedStructure, BearsOnTheGroundAsIfItHadStoodThere) {
  const Spec spec = with_block(GetParam());
  const StaticStage position = construction(spec.regions, residual);
  StandingScene placed(spec, quiet_ground(), residual, {&position, 1});
  const StandingScene stood(spec);
  EXPECT_FALSE(placed.reactions.slipping);
  EXPECT_LT(largest_difference_of_stress(placed.domain, stood.domain), 1e-3 * block_weight / 3.0);
  placed.run(0.02);
  const BodyForces forces = placed.domain.contact.forces(0);
  EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, block_weight, 1e-5 * block_weight);
  double fastest = 0.0;
  for (const Particles& set : placed.domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      fastest = std::max(fastest, std::hypot(set.vx[k], set.vy[k]));
  EXPECT_LT(fastest, 1e-6); // no kick
}

TEST_P(PlacedStructure, LeavesTheGroundAsItWasWhenItIsRemoved) {
  Spec spec = with_block(GetParam());
  const std::vector<Structure> block = std::move(spec.structures);
  spec.structures.clear();
  const std::vector<StaticStage> stages{construction(spec.regions, residual),
                                        construction(spec.regions, residual, 2.0, false, block)};
  Domain domain(spec);
  rest(domain, stages, residual);
  Domain untouched(spec);
  rest(untouched, {}, residual);
  EXPECT_LT(largest_difference_of_stress(domain, untouched), 1e-3 * block_weight / 3.0);
  const Particles& p = domain.sets.front();
  for (std::size_t k = 0; k < p.size(); ++k)
    EXPECT_NEAR(p.y[k], p.y_initial[k], 1e-6);
}

INSTANTIATE_TEST_SUITE_P(RigidAndElastic, PlacedStructure, testing::Bool());

/// The block beside a pit of 2 by 2 m.
struct BesidePit {
  Spec spec = with_block(false);
  std::vector<Region> whole;

  BesidePit() {
    spec.regions = {{0, {{-8.0, -6.0}, {8.0, -6.0}, {8.0, -2.0}, {-8.0, -2.0}}},
                    {0, {{-8.0, -2.0}, {3.0, -2.0}, {3.0, 0.0}, {-8.0, 0.0}}},
                    {0, {{5.0, -2.0}, {8.0, -2.0}, {8.0, 0.0}, {5.0, 0.0}}}};
    whole = spec.regions;
    whole.push_back({0, {{3.0, -2.0}, {5.0, -2.0}, {5.0, 0.0}, {3.0, 0.0}}});
  }

  StructureWay way_of_block(bool pit_first) const {
    const std::vector<StaticStage> stages{construction(whole, residual),
                                          pit_first
                                              ? construction(spec.regions, residual)
                                              : construction(whole, residual, 2.0, false, spec.structures)};
    Domain domain(spec);
    return rest(domain, stages, residual).ways.front();
  }

  /// The smallest and the largest heave of the ground below the block when no block stands there, m.
  std::pair<double, double> heave() const {
    Spec bare = spec;
    bare.structures.clear();
    Domain domain(bare);
    const StaticStage dig = construction(whole, residual);
    rest(domain, {&dig, 1}, residual);
    return rise_below_block(domain);
  }
};

// A building that stands there when the pit is dug goes with the ground; one that comes later does not see
// it. The way of elastic ground to its last state is the same, so that what the order changes is the heave of
// the ground, weighted by the pressure under the building.
TEST(PlacedStructure, MovesWithAPitOnlyIfThatComesLater) {
  const BesidePit scene;
  const auto [least, largest] = scene.heave();
  const double first = scene.way_of_block(true).way.y;
  const double last = scene.way_of_block(false).way.y;
  RecordProperty("difference", std::to_string(1e6 * (last - first)) + " um, heave " +
                                   std::to_string(1e6 * least) + " to " + std::to_string(1e6 * largest));
  EXPECT_GT(least, 0.0);
  EXPECT_GT(last - first, least);
  EXPECT_LT(last - first, largest);
}

} // namespace
} // namespace tremolo::mpm_domain::test
