// Ground that water seeps through, at rest under it, against closed forms: upward flow to the critical
// gradient, flow along a slope, a dam with vertical faces. Then it stays at rest in a step, without an excess
// pressure.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/head/seepage_of_ground.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

constexpr double gravity = 9.81;
constexpr double water_weight = 9810.0; // N/m3

Soil sand(double permeability, materials::Drainage drainage = materials::Drainage::coupled) {
  Soil soil{.name = "sand"};
  soil.pores = {
      .porosity = 0.388, .grain_density = 2650.0, .permeability = permeability, .drainage = drainage};
  soil.law = materials::LinearElastic{{materials::saturated_density(*soil.pores, {}), 50e6, 0.3}};
  return soil;
}

double buoyant_weight(const Soil& soil) {
  return materials::buoyant_density(*soil.pores, {}) * gravity;
}

Spec ground(Box box, double cell, std::vector<Vector> polygon) {
  Spec spec;
  spec.box = box;
  spec.cell_size = cell;
  spec.gravity = gravity;
  spec.water = {box.y_max, {}};
  spec.soils = {sand(1e-4)};
  spec.regions = {{0, std::move(polygon)}};
  return spec;
}

Spec level_ground(double depth, double cell) {
  return ground({0.0, -depth, 2.0 * cell, 0.0}, cell,
                {{0.0, -depth}, {2.0 * cell, -depth}, {2.0 * cell, 0.0}, {0.0, 0.0}});
}

void bring_to_rest(Domain& domain) {
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
}

double fastest(const Domain& domain) {
  double speed = 0.0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      speed = std::max(speed, std::hypot(set.vx[k], set.vy[k]));
  return speed;
}

double largest_excess(const Domain& domain) {
  double largest = 0.0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
      largest = std::max(largest, std::abs(excess_pressure(set, k)));
  return largest;
}

/// h = -i y: the head of free water at the surface, and more of it below.
Head upward(double depth, double gradient) {
  HeadGrid grid{.x0 = -1.0, .y0 = -depth, .h = depth, .columns = 3, .rows = 2};
  for (const double y : {-depth, 0.0})
    grid.heads.insert(grid.heads.end(), 3, -gradient * y);
  return Head(grid);
}

// sigma'_v = (gamma' - gamma_w i) z (Terzaghi 1943, Theoretical soil mechanics).
TEST(UpwardFlow, TakesTheWeightOffTheGrains) {
  for (const double gradient : {0.0, 0.5, -0.5, 0.9}) {
    Spec spec = level_ground(4.0, 0.5);
    spec.water->level = 0.0;
    Domain domain(spec);
    take_head(domain, upward(4.0, gradient));
    bring_to_rest(domain);
    const double unit = buoyant_weight(spec.soils[0]) - water_weight * gradient;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
        EXPECT_NEAR(set.syy[k], unit * set.y[k], 1e-6 * 4.0 * buoyant_weight(spec.soils[0])) << gradient;
        EXPECT_NEAR(set.pore_pressure[k], -water_weight * (1.0 + gradient) * set.y[k], 1e-6);
      }
  }
}

TEST(UpwardFlow, CarriesTheSandAtTheCriticalGradient) {
  Spec spec = level_ground(4.0, 0.5);
  spec.water->level = 0.0;
  const double critical = buoyant_weight(spec.soils[0]) / water_weight;
  EXPECT_NEAR(critical, 1.009, 0.002);
  Domain domain(spec);
  take_head(domain, upward(4.0, critical));
  bring_to_rest(domain);
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
      EXPECT_LT(std::abs(set.syy[k]), 0.01 * 4.0 * buoyant_weight(spec.soils[0]));
}

/// A dam with vertical faces on the base of the model.
Spec dam(double cell) {
  Spec spec = ground({0.0, 0.0, 20.0, 10.0}, cell, {{5.0, 0.0}, {15.0, 0.0}, {15.0, 10.0}, {5.0, 10.0}});
  spec.water->seepage = {8.0, 2.0};
  return spec;
}

TEST(SeepageOfGround, ThroughADamIsCharnys) {
  const SeepageOfGround seepage = seep(dam(0.25));
  EXPECT_NEAR(seepage.found.discharge, 1e-4 * 3.0, 0.02 * 1e-4 * 3.0);
  ASSERT_TRUE(seepage.found.exit);
  EXPECT_NEAR(seepage.found.exit->x, 15.0, 1e-9);
  EXPECT_NEAR(seepage.found.exit->y, 2.76, 0.15);
  for (const auto& [x, y] :
       {std::pair(7.5, 7.28), std::pair(10.0, 6.27), std::pair(12.5, 4.96), std::pair(14.0, 3.92)})
    EXPECT_NEAR(seepage.head.surface(x, 0.0, 10.0), y, 0.1) << x;
}

// Where h = y + cos^2(b) (s(x) - y) under a surface s of slope b, water flows along it: p = gamma_w z cos^2
// b.
TEST(SeepageOfGround, AlongASlopeHasThePressureOfParallelFlow) {
  const double slope = std::tan(15.0 * std::numbers::pi / 180.0);
  const double length = 40.0;
  const double fall = slope * length;
  Spec spec =
      ground({0.0, -15.0, length, 0.0}, 0.25, {{0.0, -15.0}, {length, -15.0}, {length, -fall}, {0.0, 0.0}});
  spec.soils.push_back(sand(1e-10)); // 4 m below the surface
  spec.regions.push_back({1, {{0.0, -15.0}, {length, -15.0}, {length, -fall - 4.0}, {0.0, -4.0}}});
  spec.water->seepage = {0.0, -fall};
  const SeepageOfGround seepage = seep(spec);
  const double cos2 = 1.0 / (1.0 + slope * slope);
  for (const double x : {17.0, 20.0, 23.0})
    for (const double z : {1.0, 2.0, 3.0}) {
      const double y = -slope * x - z;
      EXPECT_NEAR(seepage.head.at(x, y).head - y, cos2 * z, 0.02 * cos2 * z) << x << " " << z;
    }
}

/// A slope of 20 degrees between level ground, 40 m wide.
Spec slope_between(double cell) {
  return ground({0.0, 0.0, 40.0, 10.0}, cell,
                {{0.0, 0.0}, {40.0, 0.0}, {40.0, 4.0}, {27.0, 4.0}, {13.0, 9.0}, {0.0, 9.0}});
}

void expect_rest(const Spec& spec) {
  Domain domain(spec);
  EXPECT_TRUE(domain.has_seepage());
  bring_to_rest(domain);
  EXPECT_LT(largest_excess(domain), 1e-6);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  while (stepper.time() < 0.1)
    stepper.step();
  EXPECT_LT(fastest(domain), 1e-6);
  EXPECT_LT(largest_excess(domain), 1.0);
}

TEST(GroundUnderSeepage, StaysAtRestWithoutExcessPressure) {
  Spec spec = slope_between(0.5);
  spec.water->seepage = {7.5, 4.5};
  expect_rest(spec);
}

/// The residual of the ledger over the kinetic energy that the ground is given.
double ledger_error(const Spec& spec) {
  Domain domain(spec);
  bring_to_rest(domain);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      set.vx[k] = 0.1 * std::cos(0.3 * set.y[k]);
      set.vy[k] = 0.1 * std::sin(0.2 * set.x[k]);
      if (set.traits.flowing) {
        set.wx[k] = set.vx[k];
        set.wy[k] = set.vy[k];
      }
    }
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  while (stepper.time() < 0.05)
    stepper.step();
  return std::abs(domain.energy.residual()) / domain.energy.kinetic_start;
}

// The work of the seepage force is booked with that of gravity. It is as large as the kinetic energy here;
// what the ledger misses is the error of the time integration, which goes with the step.
TEST(GroundUnderSeepage, BooksTheWorkOfTheSeepageForce) {
  Spec spec = slope_between(1.0);
  spec.water->seepage = {7.5, 4.5};
  EXPECT_LT(ledger_error(spec), 1e-4);
  spec.soils = {sand(1e-4, materials::Drainage::drained)};
  const double whole = ledger_error(spec);
  EXPECT_LT(whole, 2e-3);
  spec.scheme.fraction *= 0.5;
  EXPECT_LT(ledger_error(spec), 0.5 * whole);
}

TEST(GroundUnderALine, StaysAtRestWithoutExcessPressure) {
  Spec spec = slope_between(0.5);
  spec.water->line = {{0.0, 8.0}, {13.0, 7.0}, {27.0, 4.5}, {40.0, 4.5}};
  expect_rest(spec);
}

// The sides hold what the heads of both press on them: with them level, nothing seeps, as below a level
// table.
TEST(GroundUnderALine, IsThatBelowATableWhereTheLineIsLevel) {
  Spec table = slope_between(0.5);
  table.water->level = 5.0;
  Spec line = table;
  line.water->line = {{0.0, 5.0}, {40.0, 5.0}};
  Domain one(table);
  Domain other(line);
  bring_to_rest(one);
  bring_to_rest(other);
  ASSERT_EQ(one.sets.size(), other.sets.size());
  for (std::size_t s = 0; s < one.sets.size(); ++s)
    for (std::size_t k = 0; k < one.sets[s].size(); ++k) {
      EXPECT_NEAR(one.sets[s].sxx[k], other.sets[s].sxx[k], 1e-6);
      EXPECT_NEAR(one.sets[s].syy[k], other.sets[s].syy[k], 1e-6);
    }
}

} // namespace
} // namespace tremolo::mpm_domain
