// Beams that turn far: two end moments that roll a bar up to a circle, M = 2 pi EI/L, a ring that spins while
// it swings, and the damping of backward Euler, omega dt/2.

#include "tests/support/beam_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;
using std::numbers::pi;

TEST(LiningMotion, EndMomentsRollABarUp) {
  constexpr double length = 10.0;
  Beam bar(bar_shape(length, 20), ring_section);
  std::vector<double> forces(bar.positions().size(), 0.0);
  const std::size_t first = bar.first_dof(0) + 2;
  const std::size_t last = bar.first_dof(20) + 2;
  constexpr int steps = 400;
  for (int k = 1; k <= steps; ++k) {
    const double moment = 2.0 * pi * ring_section.bending / length * k / steps;
    forces[first] = -moment;
    forces[last] = moment;
    rest_under(bar, forces, 5, 1e-2);
  }
  rest_under(bar, forces, 4000, 1e-2);
  EXPECT_NEAR(bar.positions()[last] - bar.positions()[first], 2.0 * pi, 1e-9);
  EXPECT_NEAR(bar.position(20).x, bar.position(0).x, 1e-8);
  EXPECT_NEAR(bar.position(20).y, bar.position(0).y, 1e-8);
}

TEST(LiningMotion, KeepsMomentumAndAngularMomentumWhileItSpins) {
  Beam ring(ring_shape(64, {10}), ring_section);
  std::vector<double> v(ring.positions().size(), 20.0); // rad/s
  for (std::size_t k = 0; k < ring.node_count(); ++k) {
    const Vector p = ring.position(k);
    const double oval = std::cos(2.0 * std::atan2(p.y, p.x)) / ring_radius; // 1 m/s
    v[ring.first_dof(k)] = -20.0 * p.y + oval * p.x + 3.0;
    v[ring.first_dof(k) + 1] = 20.0 * p.x + oval * p.y;
  }
  ring.set_velocities(v);
  const auto before = momenta(ring);
  const std::vector<double> none(v.size(), 0.0);
  const double start = ring.kinetic_energy();
  for (int k = 0; k < 700; ++k) {
    const BeamStep step(ring, 5e-4, 5e-4, none);
    ring.set_velocities(step.trial());
    ring.move(5e-4);
  }
  EXPECT_GT(ring.positions()[2], 2.0 * pi); // more than a turn
  EXPECT_LT(ring.kinetic_energy() + ring.strain_energy(), start);
  const auto after = momenta(ring);
  const double momentum = ring.mass() * 20.0 * ring_radius; // of its parts
  EXPECT_NEAR(after[0], before[0], 1e-12 * momentum);
  EXPECT_NEAR(after[1], before[1], 1e-12 * momentum);
  EXPECT_NEAR(after[2], before[2], 1e-12 * std::abs(before[2]));
}

TEST(LiningMotion, LosesWhatBackwardEulerDamps) {
  Beam ring(ring_shape(64), ring_section);
  std::vector<double> v(ring.positions().size(), 0.0);
  for (std::size_t k = 0; k < ring.node_count(); ++k) {
    // Without strain of its axis: u_r = cos 2 a, u_t = -sin(2 a)/2, and the turn of its sections.
    const double a = std::atan2(ring.position(k).y, ring.position(k).x);
    const double ur = 1e-3 * std::cos(2.0 * a);
    const double ut = -0.5e-3 * std::sin(2.0 * a);
    const std::size_t x = ring.first_dof(k);
    v[x] = ur * std::cos(a) - ut * std::sin(a);
    v[x + 1] = ur * std::sin(a) + ut * std::cos(a);
    v[x + 2] = (ut + 2e-3 * std::sin(2.0 * a)) / ring_radius;
  }
  ring.set_velocities(v);
  const std::vector<double> none(v.size(), 0.0);
  const double start = ring.kinetic_energy();
  constexpr double dt = 5.35e-4;
  const double omega = 2.0 * pi * 14.432;
  constexpr int steps = 400;
  for (int k = 0; k < steps; ++k) {
    const BeamStep step(ring, dt, dt, none);
    ring.set_velocities(step.trial());
    ring.move(dt);
  }
  const double left = (ring.kinetic_energy() + ring.strain_energy()) / start;
  const double damping = -std::log(left) / (2.0 * omega * dt * steps);
  EXPECT_NEAR(damping, 0.5 * omega * dt, 0.03 * 0.5 * omega * dt);
}

} // namespace
} // namespace tremolo::mpm_domain
