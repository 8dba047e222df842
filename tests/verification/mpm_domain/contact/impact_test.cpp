// An elastic structure as a bar that hits a bar of soil of its own size and stiffness: both exchange their
// velocities, after a time in which a wave runs along both and back.

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::quiet_ground;
using test_support::rectangle;
using test_support::structure;

/// Momentum along x of both, N s/m.
struct Momenta {
  double of_soil = 0.0, of_structure = 0.0;

  explicit Momenta(const Domain& domain) {
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        (set.body ? of_structure : of_soil) += set.mass[k] * set.vx[k];
  }
};

TEST(ElasticBars, ExchangeTheirVelocities) {
  constexpr double h = 0.5, length = 20 * h, thickness = 1.0, density = 2000.0; // m, kg/m3
  constexpr double young = 2e8, speed = 0.1;                                    // Pa, m/s
  Spec spec = flat_ground(40.0, 4.0, h, {density, young, 0.0});
  spec.gravity = 0.0;
  spec.scheme.fraction = 0.95; // fronts are steep
  spec.regions.front().polygon = rectangle(0.0, -2.0, length, -1.0);
  spec.structures = {structure(rectangle(-length, -2.0, 0.0, -1.0), density, 0.0)};
  spec.structures.front().stiffness = Stiffness{young, 0.0};
  Domain domain(spec);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k)
      set.vx[k] = speed;
  const Momenta start(domain);
  const double wave = std::sqrt(young / density);
  const double contact = 2.0 * length / wave;
  const double pressure = 0.5 * density * wave * speed * thickness; // rho c v/2
  Stepper stepper(domain, 0.0, quiet_ground());
  double parted = 0.0;
  double impulse = 0.0;
  while (stepper.time() < 1.5 * contact) {
    stepper.step();
    const double force = -domain.contact.forces(0).normal.force.x;
    if (stepper.time() < 0.75 * contact)
      impulse += stepper.kick() * force;
    if (force > 0.02 * pressure)
      parted = stepper.time();
  }
  const Momenta end(domain);
  EXPECT_NEAR(end.of_soil + end.of_structure, start.of_structure, 1e-12 * start.of_structure);
  EXPECT_NEAR(end.of_soil, start.of_structure, 0.02 * start.of_structure);
  EXPECT_NEAR(impulse, 0.75 * contact * pressure, 0.03 * contact * pressure);
  EXPECT_NEAR(parted, contact, 0.05 * contact);
  const EnergyLedger& energy = domain.energy;
  const double given = energy.kinetic_start;
  EXPECT_NEAR(given, 0.5 * start.of_structure * speed, 1e-6 * given);
  const double lost = energy.impact + energy.friction - energy.transfer;
  EXPECT_GE(lost, 0.0);
  EXPECT_LT(lost, 0.05 * given);
  EXPECT_LT(std::abs(energy.residual()), 5e-3 * given);
  RecordProperty("momentum_passed", std::to_string(end.of_soil / start.of_structure));
  RecordProperty("contact_over_exact", std::to_string(parted / contact));
  RecordProperty("energy_lost", std::to_string(lost / given));
}

} // namespace
} // namespace tremolo::mpm_domain
