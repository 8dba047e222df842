// A rigid block under its weight: on flat ground it bears on the soil with all of it; on an incline it rests
// below the angle of friction and slides above it with a = g (sin - mu cos), at any angle to the grid; under
// shaking it slides as Newmark's (1965) integral says.

#include "standing_block.hpp"
#include "tests/support/inclined_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::exact_acceleration;
using test_support::flat_ground;
using test_support::inclined_block;
using test_support::measured_acceleration;
using test_support::rectangle;
using test_support::StandingScene;
using test_support::structure;

constexpr double gravity = 9.81; // m/s2
const materials::Elasticity rock{2000.0, 2e9, 0.2};

class Depth : public testing::TestWithParam<double> {};

/// The depth of the base: on the surface, a little or a cell or two below it.
TEST_P(Depth, BearsOnTheSoilWithItsWeightAndStaysWhereItIs) {
  Spec spec = flat_ground(12.0, 4.0, 0.5, {1900.0, 2e8, 0.3});
  spec.structures = {structure(rectangle(-1.5, -GetParam(), 1.5, 3.0 - GetParam()), 2000.0, 0.5)};
  StandingScene scene(spec);
  EXPECT_FALSE(scene.reactions.slipping);
  scene.stepper.step();
  for (const Particles& set : scene.domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      EXPECT_LT(std::hypot(set.vx[k], set.vy[k]), 1e-6); // no kick
  test::expect_to_bear(scene, 9.0 * 2000.0 * gravity, 0.5, 1e-8);
  EXPECT_NEAR(scene.body().centre().y, scene.body().start().y, 1e-10);
  EXPECT_NEAR(scene.body().tilt(), 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Blocks, Depth, testing::Values(0.0, 1e-3, 0.25, 1.0));

struct Incline {
  double degrees;
  double share; ///< mu over the tangent of the angle

  double angle() const { return degrees * std::numbers::pi / 180.0; }
  double friction() const { return share * std::tan(angle()); }
  friend void PrintTo(const Incline& incline, std::ostream* out) {
    *out << incline.degrees << " degrees, friction " << incline.share << " of the tangent";
  }
};

class Rests : public testing::TestWithParam<Incline> {};

TEST_P(Rests, BelowTheAngleOfFriction) {
  StandingScene scene(inclined_block(GetParam().angle(), GetParam().friction()));
  EXPECT_FALSE(scene.reactions.slipping);
  const Vector start = scene.body().centre();
  scene.run(0.5);
  const Vector now = scene.body().centre();
  EXPECT_LT(std::hypot(now.x - start.x, now.y - start.y), 1e-8); // free fall: 1.2 m
}
INSTANTIATE_TEST_SUITE_P(Angles, Rests,
                         testing::Values(Incline{5.0, 1.02}, Incline{10.0, 1.02}, Incline{20.0, 1.02},
                                         Incline{30.0, 1.02}, Incline{45.0, 1.02}));

class Slides : public testing::TestWithParam<Incline> {};

TEST_P(Slides, AboveTheAngleOfFriction) {
  const double angle = GetParam().angle();
  StandingScene scene(inclined_block(angle, GetParam().friction()));
  EXPECT_TRUE(scene.reactions.slipping); // bonds held it through the gravity stage
  const double acceleration = measured_acceleration(scene, angle);
  const double exact = exact_acceleration(angle, GetParam().friction());
  EXPECT_NEAR(acceleration, exact, 0.01 * gravity * std::sin(angle));
  RecordProperty("acceleration_over_exact", std::to_string(acceleration / exact));
  const EnergyLedger& energy = scene.domain.energy;
  EXPECT_GE(energy.friction, 0.0);
  EXPECT_LT(std::abs(energy.residual()), 1e-3 * energy.gravity);
}
INSTANTIATE_TEST_SUITE_P(Angles, Slides,
                         testing::Values(Incline{5.0, 0.0}, Incline{5.0, 0.8}, Incline{10.0, 0.5},
                                         Incline{20.0, 0.0}, Incline{20.0, 0.8}, Incline{30.0, 0.8},
                                         Incline{45.0, 0.0}, Incline{45.0, 0.3}, Incline{45.0, 0.6}));

/// A block is thrown aslant into soil. Named as two soils, the same soil has its particles in another order.
std::vector<double> thrown(int soils) {
  Spec spec = flat_ground(8.0, 3.0, 0.5, {2000.0, 1e9, 0.2});
  spec.gravity = 0.0;
  spec.structures = {structure(rectangle(-1.0, -0.25, 1.0, 1.0), 2000.0, 0.3)};
  if (soils == 2) {
    spec.soils.push_back(spec.soils.front());
    spec.soils.back().name = "same";
    spec.regions.push_back({1, rectangle(-4.0, -3.0, 0.3, 0.0)});
    spec.structures.front().friction.assign(2, 0.3);
    spec.structures.front().adhesion.assign(2, 0.0);
  }
  Domain domain(spec);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  const Vector position = domain.contact.bodies().front().centre();
  test_support::set_bodies(domain, {{position.x, position.y, 0.0, 0.5, -0.5, 0.2}});
  while (stepper.steps() < 200)
    stepper.step();
  EXPECT_GT(domain.energy.friction, 0.0);
  return domain.contact.bodies().front().state();
}

TEST(ThrownBlock, KnowsNoOrderOfParticles) {
  const std::vector<double> one = thrown(1);
  const std::vector<double> other = thrown(2);
  for (std::size_t k = 0; k < one.size(); ++k)
    EXPECT_NEAR(other[k], one[k], 1e-12) << k;
}

/// Velocity of the ground: a wave train that begins and ends at rest.
double ground_velocity(double t) {
  constexpr double peak = 0.6, frequency = 2.0, duration = 1.5; // m/s, Hz, s
  if (t <= 0.0 || t >= duration)
    return 0.0;
  return peak * std::pow(std::sin(std::numbers::pi * t / duration), 2) *
         std::sin(2.0 * std::numbers::pi * frequency * t);
}

TEST(ShakenBlock, SlidesAsNewmarkSays) {
  constexpr double friction = 0.2;
  Spec spec = flat_ground(16.0, 4.0, 0.5, rock);
  spec.structures = {structure(rectangle(-2.0, 0.0, 2.0, 1.0), 2000.0, friction)};
  StandingScene scene(spec, [](long, double time, std::span<const Vector>, std::span<eq6::FreeField> field) {
    for (eq6::FreeField& face : field)
      face = {{ground_velocity(time), 0.0}, {}};
  });
  // The stiff ground lags behind its faces a little: Newmark takes the motion of the ground itself.
  const auto ground = [&] {
    const Particles& soil = scene.domain.sets.front();
    return std::inner_product(soil.mass.begin(), soil.mass.end(), soil.vx.begin(), 0.0) /
           std::accumulate(soil.mass.begin(), soil.mass.end(), 0.0);
  };
  double block = 0.0; // Newmark's velocity, m/s
  double slid = 0.0;  // and way of the block on the ground, m
  double most = 0.0;
  double way = 0.0; // of the ground
  double before = 0.0;
  while (scene.stepper.time() < 2.0) {
    scene.stepper.step();
    const double now = ground();
    const double dt = scene.stepper.dt();
    const double step = friction * gravity * scene.stepper.kick();
    const double relative = now - block;
    block += std::clamp(relative, -step, step);
    slid += dt * 0.5 * ((block - now) + (block - before));
    before = now;
    way += dt * now;
    most = std::max(most, std::abs(slid));
  }
  const double moved = scene.body().centre().x - scene.body().start().x - way;
  EXPECT_GT(most, 0.05); // it slides to and fro
  EXPECT_NEAR(moved, slid, 0.02 * most);
  EXPECT_NEAR(scene.body().motion().velocity.x, 0.0, 1e-3);
  const EnergyLedger& energy = scene.domain.energy;
  EXPECT_LT(std::abs(energy.residual()), 0.02 * std::max(energy.input, energy.friction));
}

} // namespace
} // namespace tremolo::mpm_domain
