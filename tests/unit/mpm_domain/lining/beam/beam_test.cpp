// What a beam is made of.

#include "tests/support/beam_ring.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

TEST(Beam, WeighsWhatItsAxisIsLong) {
  const Beam ring(ring_shape(64), ring_section);
  // The polygon with the circle's area is longer than it by a^2/6, a = 2 pi/64.
  EXPECT_NEAR(ring.mass(), 2.0 * std::numbers::pi * ring_radius * ring_section.mass, 1e-3 * ring.mass());
  EXPECT_GT(ring.mass(), 2.0 * std::numbers::pi * ring_radius * ring_section.mass);
}

TEST(Beam, IsFreeOfStressAtTheStartAndAfterARotation) {
  Beam ring(ring_shape(16, {3}), ring_section);
  for (const double force : ring.internal_forces())
    EXPECT_NEAR(force, 0.0, 1e-4); // N/m, where EA is 1e10
  // A state in which everything has turned by one and a quarter of a turn.
  const double turn = 2.5 * std::numbers::pi;
  std::vector<double> state = ring.state();
  std::vector<bool> is_turn(ring.positions().size(), true);
  for (std::size_t k = 0; k < ring.node_count(); ++k) {
    const std::size_t x = ring.first_dof(k);
    const Vector p = ring.position(k);
    state[x] = std::cos(turn) * p.x - std::sin(turn) * p.y;
    state[x + 1] = std::sin(turn) * p.x + std::cos(turn) * p.y;
    is_turn[x] = is_turn[x + 1] = false;
  }
  for (std::size_t i = 0; i < is_turn.size(); ++i)
    if (is_turn[i])
      state[i] = turn;
  ring.set_state(state);
  for (const double force : ring.internal_forces())
    EXPECT_NEAR(force, 0.0, 1e-4);
}

TEST(Beam, TakesForcesFromItsStrainEnergy) {
  Beam ring(ring_shape(12, {5}), ring_section);
  std::vector<double> v(ring.positions().size());
  for (std::size_t i = 0; i < v.size(); ++i)
    v[i] = 0.02 * std::sin(1.0 + 2.7 * static_cast<double>(i));
  ring.set_velocities(v);
  ring.move(1.0);
  const std::vector<double> forces = ring.internal_forces();
  const double step = 1e-6;
  for (std::size_t i = 0; i < v.size(); ++i) {
    double energy[2];
    for (const int side : {0, 1}) {
      Beam moved = ring;
      std::vector<double> away(v.size(), 0.0);
      away[i] = side == 0 ? -step : step;
      moved.set_velocities(away);
      moved.move(1.0);
      energy[side] = moved.strain_energy();
    }
    EXPECT_NEAR(forces[i], (energy[1] - energy[0]) / (2.0 * step), 1e-7 * ring_section.axial * 0.02) << i;
  }
}

TEST(Beam, KeepsItsStressWhereItIsStrainedInPlace) {
  Beam moved(ring_shape(24), ring_section);
  std::vector<double> v(moved.positions().size());
  for (std::size_t i = 0; i < v.size(); ++i)
    v[i] = 1e-6 * std::sin(static_cast<double>(i));
  moved.set_velocities(v);
  Beam strained = moved;
  moved.move(1.0);
  strained.strain_in_place(1.0);
  for (std::size_t e = 0; e < moved.elements().size(); ++e) {
    EXPECT_NEAR(strained.forces(e).moment, moved.forces(e).moment, 1e-3);
    EXPECT_NEAR(strained.forces(e).axial, moved.forces(e).axial, 1.0);
  }
  EXPECT_EQ(strained.position(5).x, ring_shape(24).nodes[5].x);
  Beam restored(ring_shape(24), ring_section);
  restored.set_state(strained.state());
  EXPECT_EQ(restored.forces(7).moment, strained.forces(7).moment);
}

TEST(Beam, RefusesShapesThatAreNone) {
  EXPECT_THROW(Beam({.nodes = {{0.0, 0.0}, {1.0, 0.0}}}, ring_section), std::invalid_argument);
  EXPECT_THROW(Beam({.nodes = {{0.0, 0.0}, {0.0, 0.0}}, .closed = false}, ring_section),
               std::invalid_argument);
  BeamShape bar = bar_shape(1.0, 4);
  bar.hinges = {4};
  EXPECT_THROW(Beam(bar, ring_section), std::invalid_argument);
  EXPECT_THROW(Beam(ring_shape(8), ring_section).set_state(std::vector<double>(3)), std::runtime_error);
}

} // namespace
} // namespace tremolo::mpm_domain
