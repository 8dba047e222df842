// A slender block that rocks on stiff ground, as Housner (1963) has it: half a cycle from the ground and back
// takes 2 acosh(1/(1 - theta/alpha))/p with p^2 = 3 g/(4 R), and each impact leaves the share r = 1 - 3/2
// sin^2 alpha of the spin.

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::rectangle;
using test_support::set_bodies;
using test_support::StandingScene;
using test_support::structure;

constexpr double gravity = 9.81; // m/s2
constexpr double width = 1.0, height = 4.0;
const double radius = 0.5 * std::hypot(width, height);
const double alpha = std::atan2(width, height);
const double p = std::sqrt(3.0 * gravity / (4.0 * radius));

/// Time from rest at a tilt (rad) to the ground, s.
double quarter_period(double tilt) {
  return std::acosh(1.0 / (1.0 - tilt / alpha)) / p;
}

/// Energy of a tilt, over M g R.
double lift(double tilt) {
  return std::cos(alpha - tilt) - std::cos(alpha);
}

/// Gives a block a spin (rad/s) about its left toe.
void push(Domain& domain, double spin) {
  const Vector toe{-0.5 * width, 0.0};
  if (!domain.contact.is_elastic(0))
    return set_bodies(domain, {{0.0, 0.5 * height, 0.0, -spin * 0.5 * height, spin * 0.5 * width, spin}});
  const double h = domain.finest_lattice().h;
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k) {
      set.vx[k] = -spin * (set.y[k] - toe.y);
      set.vy[k] = spin * (set.x[k] - toe.x);
      const double quarter = 0.25 * h; // particles stand at quarters of cells: xi (1 - xi) and the box's part
      const double moment = 3.0 * quarter * quarter;
      set.bxy[k] = -spin * moment;
      set.byx[k] = spin * moment;
    }
}

class RockingBlock : public testing::TestWithParam<bool> {};

TEST_P(RockingBlock, HasHousnersPeriodAndRestitution) {
  Spec spec = flat_ground(6.0, 1.5, 0.25, {2000.0, 2e9, 0.2});
  spec.structures = {structure(rectangle(-0.5 * width, 0.0, 0.5 * width, height), 2000.0, 1.0)};
  if (GetParam())
    spec.structures.front().stiffness = Stiffness{4e9, 0.2};
  StandingScene scene(spec);
  // A spin about the left toe that lifts the block to half its angle of overturning.
  const double spin = std::sqrt(1.5 * gravity / radius * lift(0.5 * alpha));
  push(scene.domain, spin);
  struct Peak {
    double time, tilt;
  };
  std::vector<Peak> peaks;
  double before = spin;
  while (scene.stepper.time() < 2.1) {
    scene.stepper.step();
    const double now = scene.body().motion().spin;
    if (before * now < 0.0)
      peaks.push_back({scene.stepper.time(), std::abs(scene.body().tilt())});
    before = now;
  }
  ASSERT_EQ(peaks.size(), 2U);
  EXPECT_NEAR(peaks[0].tilt, 0.5 * alpha, 0.01 * alpha);
  EXPECT_NEAR(peaks[0].time, quarter_period(0.5 * alpha), 0.01 * peaks[0].time);
  const double half_cycle = peaks[1].time - peaks[0].time;
  EXPECT_NEAR(half_cycle, quarter_period(peaks[0].tilt) + quarter_period(peaks[1].tilt), 0.05 * half_cycle);
  const double restitution = std::sqrt(lift(peaks[1].tilt) / lift(peaks[0].tilt));
  EXPECT_NEAR(restitution, 1.0 - 1.5 * std::pow(std::sin(alpha), 2), 0.05);
  RecordProperty("restitution", std::to_string(restitution));
  const double given = 0.5 * scene.body().mass() * (4.0 / 3.0) * radius * radius * spin * spin;
  // No entry knows of the restart of a rigid body.
  EXPECT_NEAR(scene.domain.energy.residual(), GetParam() ? 0.0 : given, 0.02 * given);
  RecordProperty("half_cycle_over_exact", std::to_string(half_cycle / (quarter_period(peaks[0].tilt) +
                                                                       quarter_period(peaks[1].tilt))));
}

INSTANTIATE_TEST_SUITE_P(Rigid, RockingBlock, testing::Values(false));
INSTANTIATE_TEST_SUITE_P(Elastic, RockingBlock, testing::Values(true));

} // namespace
} // namespace tremolo::mpm_domain
