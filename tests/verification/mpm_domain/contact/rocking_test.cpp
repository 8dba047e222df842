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

TEST(RockingBlock, HasHousnersPeriodAndRestitution) {
  Spec spec = flat_ground(6.0, 1.5, 0.25, {2000.0, 2e9, 0.2});
  spec.structures = {structure(rectangle(-0.5 * width, 0.0, 0.5 * width, height), 2000.0, 1.0)};
  StandingScene scene(spec);
  // A spin about the left toe that lifts the block to half its angle of overturning.
  const double spin = std::sqrt(1.5 * gravity / radius * lift(0.5 * alpha));
  set_bodies(scene.domain, {{0.0, 0.5 * height, 0.0, -spin * 0.5 * height, spin * 0.5 * width, spin}});
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
  EXPECT_NEAR(scene.domain.energy.residual(), given, 0.02 * given); // no entry knows of the restart
}

} // namespace
} // namespace tremolo::mpm_domain
