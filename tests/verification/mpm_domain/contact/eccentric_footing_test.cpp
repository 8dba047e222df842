// A rigid smooth strip foundation under an eccentric load tilts as on an elastic half-space:
// theta = 16 (1 - nu^2) M/(pi E B^2) (Muskhelishvili 1953).

#include "mpm_domain/particles/fill/rest_stress.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::structure;

constexpr double width = 4.0;                // B, m
constexpr double young = 5e7, poisson = 0.3; // of the soil, Pa
constexpr double gravity = 9.81;             // m/s2

/// A foundation that is higher on its right half, on 20 cells over its width, in a box 6 B wide and 2.5 B
/// deep that repeats itself aside and stands on a stiff base.
Spec foundation() {
  Spec spec = flat_ground(6.0 * width, 2.5 * width, 0.4, {1000.0, young, poisson});
  spec.refine = {{{-4.0, -2.0, 4.0, 0.0}, 1}};
  spec.sides = Sides::periodic;
  spec.below_base = materials::Elasticity{2600.0, 1e13, 0.2};
  spec.soils.front().damping_time = 5e-4;
  spec.structures = {
      structure({{-2.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}, {0.0, 0.5}, {-2.0, 0.5}}, 1000.0, 0.0)};
  return spec;
}

TEST(EccentricFooting, TiltsAsOnAnElasticHalfSpace) {
  Domain domain(foundation());
  set_rest_stress(domain.sets, domain.spec); // the foundation has no weight yet
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  const RigidBody& body = domain.contact.bodies().front();
  const double moment = body.mass() * gravity * body.centre().x;
  const double exact = 16.0 * (1.0 - poisson * poisson) * moment / (std::numbers::pi * young * width * width);
  double sum = 0.0; // of the tilt to the right once it has swung out, rad
  int count = 0;
  while (stepper.time() < 0.6) {
    stepper.step();
    if (stepper.time() < 0.2)
      continue;
    sum -= body.tilt();
    ++count;
  }
  const double tilt = sum / count;
  EXPECT_NEAR(tilt, exact, 0.1 * exact);
  RecordProperty("tilt_over_exact", std::to_string(tilt / exact));
}

} // namespace
} // namespace tremolo::mpm_domain
