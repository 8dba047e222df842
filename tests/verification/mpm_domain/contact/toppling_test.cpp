// A leaning rigid block stands while its centre of mass is above its base, and topples where it is beyond it.

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::StandingScene;
using test_support::structure;

/// Tilt after a time (s) of a block whose centre of mass is aside of the middle of its base by a share of
/// half its width, over that at which a straight one of its width and height overturns. The ground bears all
/// of it on the outermost nodes of the base, which coincide with its corners.
double tilt_over_overturning(double share, double duration) {
  constexpr double width = 1.0, height = 2.0; // m
  Spec spec = flat_ground(6.0, 1.5, 0.25, {2000.0, 2e9, 0.2});
  const double lean = share * width; // of the top
  spec.structures = {structure(
      {{-0.5 * width, 0.0}, {0.5 * width, 0.0}, {0.5 * width - lean, height}, {-0.5 * width - lean, height}},
      2000.0, 1.0)};
  StandingScene scene(spec);
  scene.run(duration);
  return scene.body().tilt() / std::atan2(width, height);
}

TEST(LeaningBlock, TopplesWhereItsCentreOfMassLeavesItsBase) {
  const double stands = tilt_over_overturning(0.97, 1.0);
  const double topples = tilt_over_overturning(1.03, 1.0);
  EXPECT_LT(std::abs(stands), 1e-3);
  EXPECT_GT(topples, 0.1);
  RecordProperty("tilt_at_0.97", std::to_string(stands));
  RecordProperty("tilt_at_1.03", std::to_string(topples));
}

} // namespace
} // namespace tremolo::mpm_domain
