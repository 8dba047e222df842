#pragma once

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

namespace tremolo::mpm_domain::test {

/// Ten times within a duration (s) the first structure bears on the soil with its weight (N/m) and not aside,
/// to an error in weights.
inline void expect_to_bear(test_support::StandingScene& scene, double weight, double duration, double error) {
  for (int k = 0; k < 10; ++k) {
    scene.run(0.1 * duration);
    const BodyForces forces = scene.domain.contact.forces(0);
    EXPECT_NEAR(-forces.weight.force.y, weight, 1e-9 * weight);
    EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, weight, error * weight);
    EXPECT_NEAR(forces.normal.force.x + forces.friction.force.x, 0.0, error * weight);
  }
}

} // namespace tremolo::mpm_domain::test
