// A lined tunnel in a domain. In ground that was at rest when the lining took the place of the soil, with
// stresses p = (s_v + s_h)/2 and q = (s_v - s_h)/2 at its axis, the ring carries (Einstein and Schwartz 1979,
// with the ground touching it at R_o = R + t/2)
//
//     N_0 = -p R_o/(1 + 2 G R/(EA)).

#include "lining_state.hpp"

#include "mpm_domain/particles/fill/rest_stress.hpp"
#include "mpm_domain/transfer/out_of_reach.hpp"
#include "tests/support/lined_ring.hpp"
#include "tests/support/saved_state.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

constexpr Vector centre{0.13, -12.21};
constexpr materials::Elasticity ground{1900.0, 5e7, 0.3};

Spec tunnel(double friction, std::vector<std::size_t> hinges = {}) {
  Spec spec = flat_ground(30.0, 24.0, 0.5, ground);
  Lining lining = ring_lining();
  for (Vector& corner : lining.outline)
    corner = {corner.x + centre.x, corner.y + centre.y};
  lining.hinges = std::move(hinges);
  lining.friction = {friction};
  lining.adhesion = {0.0};
  spec.linings = {lining};
  return spec;
}

TEST(LinedTunnel, StandsInGroundWithTheStressThatItHadBefore) {
  Domain domain(tunnel(0.5));
  set_rest_stress(domain.sets_of_soil(), domain.spec);
  const Particles& set = domain.sets.front();
  for (std::size_t k = 0; k < set.size(); ++k)
    if (set.y[k] < centre.y - 4.0) {
      EXPECT_NEAR(set.syy[k], ground.density * 9.81 * set.y[k], 0.03 * ground.density * 9.81 * 6.3)
          << set.x[k] << " " << set.y[k];
    }
}

/// A culvert 4 m wide and 3 m high outside, its walls 0.4 m thick.
Spec culvert(std::vector<std::size_t> hinges) {
  Spec spec = flat_ground(14.0, 9.0, 0.5, ground);
  Lining lining = ring_lining();
  lining.outline.clear();
  const std::vector<Vector> corners = rectangle(-2.0, -6.0, 2.0, -3.0);
  for (std::size_t c = 0; c < 4; ++c)
    for (int k = 0; k < 8; ++k) {
      const Vector& to = corners[(c + 1) % 4];
      lining.outline.push_back(
          {corners[c].x + k / 8.0 * (to.x - corners[c].x), corners[c].y + k / 8.0 * (to.y - corners[c].y)});
    }
  lining.thickness = 0.4;
  lining.section = plate_section(0.4, 30e9, 0.2, 2500.0);
  lining.hinges = std::move(hinges);
  lining.friction = {0.6};
  lining.adhesion = {0.0};
  spec.linings = {lining};
  return spec;
}

TEST(LinedTunnel, MayBeACulvertWithHinges) {
  const StandingScene scene(culvert({16, 24})); // at the ends of its roof
  EXPECT_FALSE(scene.reactions.slipping);
  const Beam& beam = scene.domain.linings.bodies().front().beam();
  const auto moment = [&](std::size_t e) { return beam.forces(e).moment; };
  // The roof spans from hinge to hinge: its moment goes to zero there, and stretches its inner face.
  const double middle = 0.5 * (moment(19) + moment(20));
  EXPECT_LT(middle, 0.0);
  const auto slope = [&](std::size_t e) { return 0.5 * beam.elements()[e].length * beam.forces(e).shear; };
  // The moment that remains comes from the soil, which also presses on the corners beyond the axes of the
  // walls.
  EXPECT_NEAR(moment(16) + slope(16), 0.0, 0.06 * std::abs(middle));
  EXPECT_NEAR(moment(23) - slope(23), 0.0, 0.06 * std::abs(middle));
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(moment(16 + k), moment(23 - k), 1e-6 * std::abs(middle));
  // Walls carry the roof.
  const double roof = ground.density * 9.81 * 3.0 * 4.0;
  const double walls = beam.forces(12).axial + beam.forces(27).axial;
  EXPECT_LT(walls, -roof);
  EXPECT_GT(walls, -2.5 * roof);
}

TEST(LinedTunnel, CarriesTheGroundAtRestAndStaysAtRest) {
  StandingScene scene(tunnel(0.6));
  EXPECT_FALSE(scene.reactions.slipping);
  const LiningBody& lining = scene.domain.linings.bodies().front();
  const double vertical = -ground.density * 9.81 * centre.y;
  const double p = 0.5 * (1.0 + ground.poisson / (1.0 - ground.poisson)) * vertical;
  const double shear = ground.young / (2.0 * (1.0 + ground.poisson));
  const double outer = ring_radius + 0.5 * ring_thickness;
  const double exact = -p * outer / (1.0 + 2.0 * shear * ring_radius / ring_section.axial);
  const double thrust = mean_thrust(lining.beam());
  RecordProperty("thrust", std::to_string(thrust / exact));
  EXPECT_NEAR(thrust, exact, 0.05 * std::abs(exact)); // the surface is four radii away
  scene.run(0.1);
  EXPECT_LT(fastest_particle(scene.domain), 1e-5);
  EXPECT_NEAR(mean_thrust(lining.beam()), thrust, 1e-4 * std::abs(thrust));
  // Contact bears the weight of the ring.
  double vertical_force = 0.0;
  for (const SegmentRows& of : lining.rows())
    vertical_force += lining.contact().impulse(of).y / scene.stepper.kick();
  EXPECT_NEAR(vertical_force, lining.beam().mass() * 9.81, 1e-3 * lining.beam().mass() * 9.81);
}

/// Lets soil near the lining begin with an oval motion, 0.1/s times the distance.
void swing(Domain& domain) {
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Vector x{set.x[k] - centre.x, set.y[k] - centre.y};
      const double near = std::exp(-0.5 * (x.x * x.x + x.y * x.y) / 9.0);
      set.vx[k] = 0.1 * near * x.x;
      set.vy[k] = -0.1 * near * x.y;
    }
}

TEST(LinedTunnel, BooksItsEnergy) {
  Spec spec = tunnel(0.4, {0, 16, 40});
  spec.gravity = 0.0;
  Domain domain(spec);
  swing(domain);
  Stepper stepper(domain, 0.0, quiet_ground());
  while (stepper.time() < 0.1)
    stepper.step();
  const EnergyLedger& energy = domain.energy;
  RecordProperty("residual", std::to_string(energy.residual() / energy.kinetic_start));
  EXPECT_NEAR(energy.residual(), 0.0, 0.005 * energy.kinetic_start);
  EXPECT_GT(energy.friction, 0.0);
  EXPECT_GT(energy.impact, 0.0);
  EXPECT_GT(energy.viscous, 0.0); // of backward Euler
  EXPECT_LT(energy.viscous, 0.03 * energy.kinetic_start);
}

TEST(LinedTunnel, GoesOnFromACheckpointWithTheSameBits) {
  const Spec spec = tunnel(0.4, {0, 16, 40});
  Domain domain(spec);
  relax_under_gravity(domain, {.residual = 1e-3}, [](long, double) {});
  swing(domain);
  Stepper stepper(domain, 0.0, quiet_ground());
  const auto run = [](Stepper& of) {
    for (int k = 0; k < 40; ++k)
      of.step();
  };
  run(stepper);
  const SavedState saved = saved_state(domain, stepper);
  run(stepper);
  Domain second(spec);
  Stepper again(second, 0.0, quiet_ground());
  restore_state(saved, second, again);
  run(again);
  expect_same(saved_state(domain, stepper), saved_state(second, again));
}

TEST(LinedTunnel, SaysWhereItHasLeftTheMesh) {
  Domain domain(tunnel(0.5));
  LiningBody& lining = domain.linings.bodies().front();
  std::vector<double> state = lining.state();
  const std::size_t positions = 3 * lining.segments().size(); // behind three numbers of each segment
  for (std::size_t k = 0; k < lining.beam().node_count(); ++k)
    state[positions + lining.beam().first_dof(k) + 1] -= 20.0;
  lining.set_state(state);
  try {
    lining.follow_sort(domain);
    FAIL() << "it reaches 11 m below the base";
  } catch (const OutOfReach& left) {
    EXPECT_NE(std::string(left.what()).find("lining 'ring' has left the mesh: it reaches from x = -3.0"),
              std::string::npos)
        << left.what();
  }
}

TEST(LinedTunnel, IsRefusedWhereItIsNotComputed) {
  Spec subcycled = tunnel(0.5);
  subcycled.scheme.subcycle = true;
  EXPECT_THROW(Domain{subcycled}, std::invalid_argument);
  Spec coarse = tunnel(0.5);
  coarse.refine = {{{-15.0, -24.0, 15.0, -12.0}, 1}};
  EXPECT_THROW(Domain{coarse}, std::invalid_argument);
  Spec narrow = tunnel(0.5);
  for (Vector& corner : narrow.linings.front().outline)
    corner.x += 11.0;
  EXPECT_THROW(Domain{narrow}, std::invalid_argument);
  Spec twins = tunnel(0.5);
  twins.linings.push_back(twins.linings.front());
  for (Vector& corner : twins.linings.back().outline)
    corner.x += 8.0; // 1.7 m apart
  EXPECT_THROW(Domain{twins}, std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
