// Bodies in liquefied soil, a heavy fluid of grains and water without effective stress: the force on a
// tunnel, the depth at which a block floats, and what friction must not do there.

#include "tests/support/liquefied_tunnel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test_support::liquefy;
using test_support::rectangle;
using test_support::saturated_flat_ground;
using test_support::StandingScene;
using test_support::structure;
using test_support::tunnel_forces;
using test_support::TunnelForces;
using test_support::heavy_fluid::gravity;
using test_support::heavy_fluid::saturated;
using test_support::heavy_fluid::water;

struct Tunnel {
  double cell_size; ///< m
  double offset;    ///< of the axis from a node, m

  friend void PrintTo(const Tunnel& tunnel, std::ostream* out) {
    *out << "cells of " << tunnel.cell_size << " m, axis off a node by " << tunnel.offset << " m";
  }
};

class TunnelInLiquefiedSoil : public testing::TestWithParam<Tunnel> {};

TEST_P(TunnelInLiquefiedSoil, IsLiftedByTheWeightOfTheHeavyFluid) {
  const TunnelForces forces = tunnel_forces(
      saturated_flat_ground(20.0, 12.0, GetParam().cell_size, materials::Drainage::undrained, 1e7),
      GetParam().offset);
  EXPECT_NEAR(forces.at_rest, 192.6e3, 0.001 * 192.6e3); // water alone
  EXPECT_NEAR(forces.total_lift(), 371.6e3, 0.02 * 371.6e3);
  EXPECT_NEAR(forces.total_lift() - TunnelForces::weight, 313.8e3, 0.02 * 313.8e3);
  RecordProperty("lift_over_heavy_fluid", std::to_string(forces.total_lift() / 371.6e3));
  EXPECT_LT(std::abs(forces.aside), 0.02 * forces.lift);
  EXPECT_LT(forces.rubbed, 0.01 * 0.4 * forces.pressed);
}

INSTANTIATE_TEST_SUITE_P(Meshes, TunnelInLiquefiedSoil,
                         testing::Values(Tunnel{0.5, 0.0}, Tunnel{0.5, 0.13}, Tunnel{0.25, 0.0},
                                         Tunnel{0.25, 0.13}));

/// The pressure at a wall is that of the cell beside it. Where sand has liquefied it grows with the depth, so
/// that under a base it is too large by what grows in half a cell, and the effective force too small by that;
/// above a roof it is the other way round. Both together are right.
TEST(LiquefiedSand, BearsABaseByThePressureOfTheCellsBelow) {
  constexpr double width = 8.0, depth = 2.0, dt = 1e-5;
  for (const double h : {0.5, 0.25}) {
    SCOPED_TRACE(h);
    Spec spec = saturated_flat_ground(20.0, 8.0, h, materials::Drainage::undrained, 1e7);
    spec.structures = {structure(rectangle(-0.5 * width, -depth, 0.5 * width, 1.0), 1000.0, 0.4)};
    Domain domain(spec);
    double effective = 0.0, total = 0.0; // N/m
    for (const ContactPoint& p : test_support::first_contact(domain, dt)) {
      effective += p.effective_impulse / dt * p.normal.y;
      total += p.normal_impulse / dt * p.normal.y;
    }
    const double buoyant = (saturated - water) * gravity;
    EXPECT_NEAR(total, buoyant * depth * width, 0.02 * buoyant * depth * width);
    EXPECT_NEAR(effective, -buoyant * 0.5 * h * width, 0.1 * buoyant * 0.5 * h * width);
  }
}

struct Wet {
  materials::Drainage drainage;
  bool elastic;
};

class WetGround : public testing::TestWithParam<Wet> {};

TEST_P(WetGround, BearsABlockByEffectiveStressAlone) {
  Spec spec = saturated_flat_ground(12.0, 5.0, 0.5, GetParam().drainage, 2e7);
  spec.water->fluid.bulk_modulus = 2e8;
  spec.structures = {structure(rectangle(-1.5, -1.0, 1.5, 2.0), 2000.0, 0.4)};
  if (GetParam().elastic)
    spec.structures.front().stiffness = Stiffness{2e8, 0.2};
  StandingScene scene(spec);
  scene.run(0.5);
  const BodyForces forces = scene.domain.contact.forces(0);
  const double weight = 9.0 * 2000.0 * gravity - 3.0 * water * gravity; // less that of the water in its place
  const double error = GetParam().elastic ? 1e-4 : 1e-6;
  EXPECT_NEAR(-forces.weight.force.y, weight, 1e-9 * weight);
  EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, weight, error * weight);
  EXPECT_NEAR(forces.water.force.y, 0.0, error * weight);
  EXPECT_NEAR(scene.body().centre().y, scene.body().start().y, GetParam().elastic ? 1e-6 : 1e-8);
}

INSTANTIATE_TEST_SUITE_P(
    Soils, WetGround,
    testing::Values(Wet{materials::Drainage::drained, false}, Wet{materials::Drainage::undrained, false},
                    Wet{materials::Drainage::coupled, false}, Wet{materials::Drainage::drained, true},
                    Wet{materials::Drainage::undrained, true}, Wet{materials::Drainage::coupled, true}));

class FloatingBlock : public testing::TestWithParam<materials::Drainage> {};

TEST_P(FloatingBlock, ComesToRestAtItsDraught) {
  constexpr double height = 2.0, density = 1000.0, h = 0.5;
  Spec spec = saturated_flat_ground(12.0, 5.0, h, GetParam(), 5e6);
  materials::MohrCoulomb sand; // that bears no tension
  sand.elastic = {saturated, 5e6, 0.3};
  sand.friction_peak = sand.friction_residual = 0.5;
  spec.soils.front().law = sand;
  spec.water->fluid.bulk_modulus = 2e7; // stiff beside what floats, and cheap
  spec.soils.front().damping_time = 5e-4;
  // Faces would go on pressing with what they held at rest, and give way.
  spec.sides = Sides::periodic;
  spec.below_base = materials::Elasticity{2600.0, 1e13, 0.2};
  spec.structures = {structure(rectangle(-1.5, -1.5, 1.5, height - 1.5), density, 0.4)};
  StandingScene scene(spec);
  liquefy(scene.domain);
  scene.run(3.0);
  double top = -1e9; // of the soil beside the block
  for (const Particles& p : scene.domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      if (std::abs(p.x[k]) > 4.0)
        top = std::max(top, p.y[k] + p.half_size);
  const double draught = top - (scene.body().centre().y - 0.5 * height);
  EXPECT_NEAR(draught, height * density / saturated, 0.25 * h);
  EXPECT_LT(std::abs(scene.body().motion().velocity.y), 0.01);
  EXPECT_LT(std::abs(scene.body().tilt()), 1e-3);
  const BodyForces forces = scene.domain.contact.forces(0);
  EXPECT_LT(std::abs(forces.friction.force.y), 0.02 * std::abs(forces.water.force.y));
  RecordProperty("draught", std::to_string(draught));
}

INSTANTIATE_TEST_SUITE_P(Soils, FloatingBlock,
                         testing::Values(materials::Drainage::undrained, materials::Drainage::coupled));

} // namespace
} // namespace tremolo::mpm_domain
