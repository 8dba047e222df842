#pragma once

// Prandtl's strip footing: a rigid punch is pressed slowly into weightless clay that is perfectly plastic and
// carries (2 + pi) times its cohesion, rough or smooth.

#include "tests/support/structure_scene.hpp"

#include <numbers>

namespace tremolo::test_support {

class PunchedClay {
public:
  static constexpr double width = 4.0;                                 // of the punch, m
  static constexpr double cohesion = 20e3;                             // Pa
  static constexpr double exact = (2.0 + std::numbers::pi) * cohesion; // Pa

  PunchedClay(double cell_size, bool rough)
      : domain(spec(cell_size, rough)), stepper(domain, 0.0, quiet_ground()) {
    const Vector position = domain.contact.bodies().front().centre();
    set_bodies(domain, {{position.x, position.y, 0.0, 0.0, -speed, 0.0}});
  }

  double sunk() const { return speed * stepper.time(); } ///< m
  /// Mean pressure under the punch over a time (s), Pa.
  double pressure(double duration) {
    const double end = stepper.time() + duration;
    double impulse = 0.0;
    double time = 0.0;
    while (stepper.time() < end) {
      stepper.step();
      const mpm_domain::BodyForces forces = domain.contact.forces(0);
      impulse += stepper.kick() * (forces.normal.force.y + forces.friction.force.y);
      time += stepper.kick();
    }
    return impulse / time / width;
  }

  mpm_domain::Domain domain;
  mpm_domain::Stepper stepper;

private:
  static constexpr double speed = 0.02; // m/s; inertia of the clay takes 1e-5 of the pressure

  static mpm_domain::Spec spec(double cell_size, bool rough) {
    mpm_domain::Spec spec = flat_ground(16.0, 4.0, cell_size, {500.0, 20e6, 0.3});
    materials::MohrCoulomb clay;
    clay.elastic = {500.0, 20e6, 0.3};
    clay.cohesion_peak = clay.cohesion_residual = cohesion;
    clay.friction_peak = clay.friction_residual = 0.0;
    spec.soils.front().law = clay;
    spec.gravity = 0.0;
    spec.sides = mpm_domain::Sides::periodic;
    spec.below_base = materials::Elasticity{2600.0, 1e13, 0.2};
    spec.structures = {structure(rectangle(-0.5 * width, 0.0, 0.5 * width, 1.0), 1e12, 0.0)};
    spec.structures.front().adhesion = {rough ? 2.0 * cohesion : 0.0};
    spec.threads = 1;
    return spec;
  }
};

} // namespace tremolo::test_support
