// Elastic bodies on the ground: they bear with their weight, shorten under it and swing as a column does,
// slide and settle as rigid ones do where they are stiff, keep momentum where they hit the ground, and go on
// from a checkpoint with the same bits.

#include "mpm_domain/particles/fill/rest_stress.hpp"
#include "standing_block.hpp"
#include "tests/support/inclined_block.hpp"
#include "tests/support/saved_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::quiet_ground;
using test_support::rectangle;
using test_support::StandingScene;
using test_support::structure;

constexpr double gravity = 9.81; // m/s2

Structure elastic(Structure body, double young, double poisson) {
  body.stiffness = Stiffness{young, poisson};
  return body;
}

/// A column on stiff smooth ground.
Spec column_of(double height, double h) {
  Spec spec = flat_ground(8.0, 2.0, h, {2000.0, 2e9, 0.2});
  spec.structures = {elastic(structure(rectangle(-0.5, 0.0, 0.5, height), 2000.0, 0.0), 5e7, 0.3)};
  return spec;
}

/// A block on or in soil, at some depth of its base.
class Block : public testing::TestWithParam<double> {};

TEST_P(Block, BearsOnTheSoilWithItsWeightAndStaysWhereItIs) {
  Spec spec = flat_ground(12.0, 4.0, 0.5, {1900.0, 2e8, 0.3});
  spec.structures = {
      elastic(structure(rectangle(-1.5, -GetParam(), 1.5, 3.0 - GetParam()), 2000.0, 0.5), 1e9, 0.2)};
  StandingScene scene(spec);
  EXPECT_FALSE(scene.reactions.slipping);
  test::expect_to_bear(scene, 9.0 * 2000.0 * gravity, 0.25, 1e-5);
  EXPECT_NEAR(scene.body().centre().y, scene.body().start().y, 1e-8);
  EXPECT_NEAR(scene.body().tilt(), 0.0, 1e-8);
}
INSTANTIATE_TEST_SUITE_P(Depths, Block, testing::Values(0.0, 1e-3, 0.25, 1.0));

/// Strain along the height that goes with the stress of a particle.
double vertical_strain(const Particles& set, std::size_t k) {
  const materials::Elasticity& e = materials::elasticity(set.law);
  return (1.0 + e.poisson) / e.young * ((1.0 - e.poisson) * set.syy[k] - e.poisson * set.sxx[k]);
}

void expect_shortening(double h) {
  constexpr double height = 4.0;
  const StandingScene scene(column_of(height, h));
  double shortening = 0.0;
  for (const Particles& set : scene.domain.body_sets())
    for (std::size_t k = 0; k < set.size(); ++k)
      shortening -= vertical_strain(set, k) * set.volume[k]; // over a width of 1 m
  const materials::Elasticity& e = materials::elasticity(scene.domain.body_sets().front().law);
  const double modulus = e.young / (1.0 - e.poisson * e.poisson); // plane strain, free sides
  const double exact = e.density * gravity * height * height / (2.0 * modulus);
  EXPECT_NEAR(shortening, exact, 5e-3 * exact);
}

TEST(Column, ShortensUnderItsWeight) {
  expect_shortening(0.25);
}

TEST(AcceptanceColumn, ShortensUnderItsWeightOnFinerCells) {
  expect_shortening(0.125);
}

/// With a tenth of the weight taken off at once, the top swings about the new length, by as much to each
/// side.
TEST(Column, SwingsAboutItsLengthWithItsPeriod) {
  constexpr double height = 4.0, share = 0.1;
  StandingScene scene(column_of(height, 0.25));
  const Particles& set = scene.domain.body_sets().front();
  const materials::Elasticity e = materials::elasticity(set.law);
  const double modulus = e.young / (1.0 - e.poisson * e.poisson);
  const double lift = share * e.density * gravity * height * height / (2.0 * modulus);
  const double period = 4.0 * height / std::sqrt(modulus / e.density);
  scene.domain.spec.gravity *= 1.0 - share;
  const auto mean_rise = [&](bool top) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < set.size(); ++k)
      if (top ? set.y_initial[k] > height - 0.125 : set.y_initial[k] < 0.125) {
        sum += set.y[k] - set.y_initial[k];
        ++count;
      }
    return sum / count;
  };
  double most = 0.0;
  double integral = 0.0;
  double before = 0.0;
  std::vector<double> crossings; // of the new length, up and down, s
  while (scene.stepper.time() < period) {
    scene.stepper.step();
    const double rise = mean_rise(true) - mean_rise(false);
    if ((before < lift) != (rise < lift))
      crossings.push_back(scene.stepper.time() - scene.stepper.dt() * (rise - lift) / (rise - before));
    integral += rise * scene.stepper.dt();
    most = std::max(most, rise);
    before = rise;
  }
  ASSERT_EQ(crossings.size(), 2U);
  const double half_period = crossings[1] - crossings[0];
  EXPECT_NEAR(integral / scene.stepper.time(), lift, 0.05 * lift);
  EXPECT_NEAR(most, 2.0 * lift, 0.1 * lift);
  EXPECT_NEAR(half_period, 0.5 * period, 0.02 * 0.5 * period);
  RecordProperty("mean_over_exact", std::to_string(integral / scene.stepper.time() / lift));
  RecordProperty("half_period_over_exact", std::to_string(half_period / (0.5 * period)));
}

/// Acceleration down an incline, m/s2.
double acceleration_on_incline(double angle, double friction, bool rigid) {
  Spec spec = test_support::inclined_block(angle, friction);
  if (!rigid)
    spec.structures.front().stiffness = Stiffness{2e9, 0.2};
  StandingScene scene(spec);
  const double acceleration = test_support::measured_acceleration(scene, angle);
  EXPECT_LT(std::abs(scene.domain.energy.residual()), 2e-3 * scene.domain.energy.gravity);
  return acceleration;
}

TEST(StiffBlock, SlidesDownAnInclineAsARigidOneDoes) {
  const double angle = 20.0 * std::numbers::pi / 180.0;
  const double friction = 0.5 * std::tan(angle);
  const double exact = test_support::exact_acceleration(angle, friction);
  const double stiff = acceleration_on_incline(angle, friction, false);
  const double rigid = acceleration_on_incline(angle, friction, true);
  EXPECT_NEAR(stiff, rigid, 0.02 * rigid);
  EXPECT_NEAR(stiff, exact, 0.02 * exact);
  RecordProperty("stiff_over_exact", std::to_string(stiff / exact));
  RecordProperty("rigid_over_exact", std::to_string(rigid / exact));
}

TEST(StiffBlock, HitsTheGroundWithAllItsMomentum) {
  Spec spec = flat_ground(16.0, 6.0, 0.5, {2000.0, 2e8, 0.25});
  spec.gravity = 0.0;
  spec.structures = {elastic(structure(rectangle(-1.0, 0.0, 1.0, 2.0), 2000.0, 0.4), 2e8, 0.2)};
  Domain domain(spec);
  for (Particles& set : domain.sets)
    if (set.body)
      for (std::size_t k = 0; k < set.size(); ++k) {
        set.vx[k] = 0.3;
        set.vy[k] = -0.5;
      }
  Stepper stepper(domain, 0.0, quiet_ground());
  Vector start;
  const auto momentum = [&] {
    Vector p;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        p = {p.x + set.mass[k] * set.vx[k], p.y + set.mass[k] * set.vy[k]};
    return p;
  };
  start = momentum();
  double carried_before = -0.5 * 8000.0;
  for (int k = 0; k < 12; ++k) { // the sides know nothing of it yet
    stepper.step();
    const Vector now = momentum();
    EXPECT_NEAR(now.x, start.x, 1e-12 * std::abs(start.y));
    EXPECT_NEAR(now.y, start.y, 1e-12 * std::abs(start.y));
    const double carried = 8000.0 * domain.contact.bodies()[0].motion().velocity.y;
    EXPECT_GT(carried, carried_before); // it slows down
    carried_before = carried;
  }
  EXPECT_GT(carried_before, -0.45 * 8000.0);
  EXPECT_GE(domain.energy.friction, 0.0);
  EXPECT_GT(domain.energy.impact, 0.0);
}

/// Settlement of a block whose weight grows by half at once, over time.
std::vector<double> settlement(bool rigid, double h) {
  Spec spec = flat_ground(16.0, 6.0, h, {1900.0, 5e7, 0.3});
  spec.structures = {structure(rectangle(-2.0, 0.0, 2.0, 2.0), 2000.0, 0.5)};
  if (!rigid)
    spec.structures.front().stiffness = Stiffness{4e9, 0.2};
  StandingScene scene(spec);
  scene.domain.spec.gravity *= 1.5;
  std::vector<double> history;
  for (int k = 1; k <= 40; ++k) {
    scene.run(0.005 * k - scene.stepper.time());
    history.push_back(scene.body().start().y - scene.body().centre().y);
  }
  return history;
}

TEST(StiffBlock, SettlesAsARigidOneDoes) {
  const std::vector<double> rigid = settlement(true, 0.5);
  const std::vector<double> stiff = settlement(false, 0.5);
  const double most = std::ranges::max(rigid);
  double difference = 0.0;
  for (std::size_t k = 0; k < rigid.size(); ++k)
    difference = std::max(difference, std::abs(stiff[k] - rigid[k]));
  EXPECT_LT(difference, 0.02 * most);
  RecordProperty("difference_over_settlement", std::to_string(difference / most));
}

TEST(AcceptanceStiffBlock, SettlesTheSameOnFinerCells) {
  const double coarse = std::ranges::max(settlement(false, 1.0));
  const double middle = std::ranges::max(settlement(false, 0.5));
  const double fine = std::ranges::max(settlement(false, 0.25));
  EXPECT_LT(std::abs(fine - middle), 0.75 * std::abs(middle - coarse));
  EXPECT_LT(std::abs(fine - middle), 0.02 * fine);
  RecordProperty("coarse_over_fine", std::to_string(coarse / fine));
  RecordProperty("middle_over_fine", std::to_string(middle / fine));
}

TEST(Elastic, BodiesBearTheirWeightsSideBySide) {
  Spec spec = flat_ground(16.0, 4.0, 0.5, {1900.0, 1e8, 0.3});
  spec.sides = Sides::periodic;
  spec.boxes = ParticleBoxes::deforming;
  spec.structures = {elastic(structure(rectangle(-6.0, -0.5, -4.0, 2.0), 1000.0, 0.4), 1e8, 0.2),
                     structure(rectangle(-1.0, 0.0, 1.0, 2.0), 2000.0, 0.4),
                     elastic(structure(rectangle(3.5, 0.0, 6.0, 1.5), 3000.0, 0.4), 2e8, 0.3)};
  for (std::size_t b = 0; b < spec.structures.size(); ++b)
    spec.structures[b].name = "body" + std::to_string(b);
  StandingScene scene(spec);
  scene.run(0.1);
  for (std::size_t b = 0; b < spec.structures.size(); ++b) {
    const BodyForces forces = scene.domain.contact.forces(b);
    const double weight = std::array{5.0 * 1000.0, 4.0 * 2000.0, 3.75 * 3000.0}[b] * gravity;
    EXPECT_NEAR(-forces.weight.force.y, weight, 1e-9 * weight) << b;
    EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, weight, 1e-4 * weight) << b;
    EXPECT_NEAR(scene.body(b).centre().y, scene.body(b).start().y, 1e-7) << b;
  }
}

/// Velocities of all particles by where they were at the start, in quarters of a cell of 0.5 m.
std::map<std::pair<long, long>, Vector> velocities(const Domain& domain) {
  std::map<std::pair<long, long>, Vector> found;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      found[{std::lround(8.0 * set.x_initial[k]), std::lround(8.0 * set.y_initial[k])}] = {set.vx[k],
                                                                                           set.vy[k]};
  return found;
}

/// A buried body of the soil's own density and stiffness, from which nothing can slide off or part, is no
/// body: both velocity fields together are the one of homogeneous ground.
TEST(Elastic, BodyOfSoilThatSticksIsSoil) {
  const materials::Elasticity soil{1900.0, 5e7, 0.3};
  Spec spec = flat_ground(12.0, 6.0, 0.5, soil);
  const auto shaking = [](long, double time, std::span<const Vector>, std::span<eq6::FreeField> field) {
    for (eq6::FreeField& face : field)
      face = {{1e-3 * std::sin(40.0 * time), 5e-4 * std::sin(50.0 * time)}, {}};
  };
  StandingScene ground(spec, shaking);
  spec.structures = {
      elastic(structure(rectangle(-1.5, -4.0, 1.0, -2.0), soil.density, 1e6), soil.young, soil.poisson)};
  // The body begins with the stress of the ground, on the same supports.
  Domain domain(spec);
  set_rest_stress(domain.sets, spec);
  replace_constraints(domain, ground.reactions);
  Stepper stepper(domain, 0.0, shaking);
  EXPECT_EQ(domain.particle_count(), ground.domain.particle_count());
  for (int k = 0; k < 5; ++k) {
    ground.run(0.05);
    while (stepper.time() < ground.stepper.time())
      stepper.step();
    const auto with = velocities(domain);
    const auto without = velocities(ground.domain);
    ASSERT_EQ(with.size(), without.size());
    for (const auto& [position, v] : without) {
      EXPECT_NEAR(with.at(position).x, v.x, 5e-9); // 5e-6 of the shaking
      EXPECT_NEAR(with.at(position).y, v.y, 5e-9);
    }
  }
  EXPECT_NEAR(domain.energy.friction, 0.0, 1e-12);
  EXPECT_NEAR(domain.energy.elastic, ground.domain.energy.elastic,
              1e-5 * std::abs(ground.domain.energy.elastic));
}

TEST(Elastic, GoesOnFromACheckpointWithTheSameBits) {
  Spec spec = flat_ground(10.0, 3.0, 0.5, {1900.0, 1e8, 0.3});
  spec.refine = {{{-4.0, -2.0, 4.0, 0.0}, 1}};
  spec.structures = {elastic(structure(rectangle(-1.2, -0.3, 1.1, 2.0), 2000.0, 0.2), 5e7, 0.2)};
  const auto shaking = [](long, double time, std::span<const Vector>, std::span<eq6::FreeField> field) {
    for (eq6::FreeField& face : field)
      face = {{0.5 * std::sin(20.0 * time), 0.2 * std::sin(15.0 * time)}, {}};
  };
  StandingScene whole(spec, shaking);
  whole.run(0.1);
  const test_support::SavedState saved = test_support::saved_state(whole.domain, whole.stepper);
  const double slid = whole.domain.energy.friction;
  whole.run(0.1);
  EXPECT_GT(whole.domain.energy.friction, slid);

  spec.threads = 1;
  StandingScene resumed(spec, shaking);
  test_support::restore_state(saved, resumed.domain, resumed.stepper);
  resumed.run(0.1);
  expect_same(test_support::saved_state(whole.domain, whole.stepper),
              test_support::saved_state(resumed.domain, resumed.stepper));
}

} // namespace
} // namespace tremolo::mpm_domain
