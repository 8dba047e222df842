// Periodic sides: the seam must be nowhere to be seen.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/grid/periodic_sides.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tremolo::mpm_domain {
namespace {

constexpr double width = 8.0; // m
constexpr double depth = 4.0;
constexpr double h = 0.5;

Domain periodic_box(double box_width, Transfer transfer, StepOrder order) {
  Spec spec = test_support::elastic_box(box_width, depth, h);
  spec.sides = mpm_domain::Sides::periodic;
  spec.scheme.transfer = transfer;
  spec.scheme.order = order;
  return Domain(spec);
}

/// A smooth velocity field of period `width`, moved by `shift`.
Vector velocity_at(double x, double y, double shift) {
  const double phase = 2.0 * std::numbers::pi * (x - shift) / width;
  return {0.4 * std::sin(phase) * std::cos(y) + 3.0, 0.2 * std::cos(2.0 * phase) + 0.1 * y};
}

void set_velocities(Domain& domain, double shift) {
  Particles& p = domain.sets.front();
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Vector v = velocity_at(p.x[k], p.y[k], shift);
    p.vx[k] = v.x;
    p.vy[k] = v.y;
  }
}

class Seam : public testing::TestWithParam<std::pair<Transfer, StepOrder>> {};

/// A field moved by a whole number of cells gives the same motion, moved; drifting at 3 m/s the particles
/// cross the seam three times.
TEST_P(Seam, CannotBeSeen) {
  const int cells = 5;
  std::vector<Particles> results;
  for (const double shift : {0.0, cells * h}) {
    Domain domain = periodic_box(width, GetParam().first, GetParam().second);
    set_velocities(domain, shift);
    Stepper stepper(domain, 0.0, test_support::no_traction(domain));
    while (stepper.time() < 4.0)
      stepper.step();
    results.push_back(domain.sets.front());
  }
  const Particles& a = results[0];
  const Particles& b = results[1];
  const int columns = static_cast<int>(2.0 * width / h);
  double difference = 0.0;
  for (std::size_t id = 0; id < a.size(); ++id) {
    const auto column = static_cast<int>(id) % columns;
    const int moved = (column + 2 * cells) % columns;
    const std::size_t twin = id - static_cast<std::size_t>(column) + static_cast<std::size_t>(moved);
    const std::size_t ka = a.index_of[id];
    const std::size_t kb = b.index_of[twin];
    difference = std::max({difference, std::abs(a.vx[ka] - b.vx[kb]), std::abs(a.vy[ka] - b.vy[kb]),
                           std::abs(a.sxy[ka] - b.sxy[kb]) / 1e6});
  }
  EXPECT_LT(difference, 1e-10);
  double lowest = 1e9;
  double highest = -1e9;
  for (const double x : a.x) {
    lowest = std::min(lowest, x);
    highest = std::max(highest, x);
  }
  EXPECT_GT(lowest, -1.5 * h); // wrapped at the last sort
  EXPECT_LT(highest, width + 1.5 * h);
}

TEST_P(Seam, KeepsMassAndMomentum) {
  Domain domain = periodic_box(width, GetParam().first, GetParam().second);
  Particles& p = domain.sets.front();
  std::mt19937 random(3);
  std::normal_distribution<double> speed(0.0, 0.1);
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.vx[k] = 2.0 + speed(random);
    p.vy[k] = speed(random);
  }
  const auto momentum = [&] {
    Vector sum;
    for (std::size_t k = 0; k < p.size(); ++k) {
      sum.x += p.mass[k] * p.vx[k];
      sum.y += p.mass[k] * p.vy[k];
    }
    return sum;
  };
  const Vector before = momentum();
  Stepper stepper(domain, 0.0, test_support::no_traction(domain));
  for (int i = 0; i < 1000; ++i)
    stepper.step();
  const Vector after = momentum();
  const double scale = 1700.0 * width * depth * 2.0;
  EXPECT_NEAR(after.x, before.x, 1e-12 * scale);
  // Nodes beyond the free surfaces with less than 1e-14 of a full cell's mass count as empty: up to
  // sqrt(1e-14) of a particle's stress times its side is lost there, the impulse of a few such steps here.
  EXPECT_NEAR(after.y, before.y, 2e-11 * scale);
  double grid_mass = 0.0;
  for (const double mass : domain.grid.mass)
    grid_mass += mass;
  EXPECT_NEAR(grid_mass, 1700.0 * width * depth, 1e-12 * 1700.0 * width * depth);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Seam,
                         testing::Values(std::pair{Transfer::apic, StepOrder::musl},
                                         std::pair{Transfer::apic, StepOrder::usl},
                                         std::pair{Transfer::flip, StepOrder::musl},
                                         std::pair{Transfer::flip, StepOrder::usl}));

/// A narrow grid has room for images on both sides. Only those that particles may touch until the next sort
/// are passed over, and these are all that they touch, wherever they move by less than a cell.
TEST(PeriodicColumn, PassesOverTheImagesThatParticlesTouch) {
  for (const double move : {-0.95 * h, 0.0, 0.95 * h}) {
    Domain domain = periodic_box(h, Transfer::apic, StepOrder::musl);
    Particles& p = domain.sets.front();
    for (std::size_t k = 0; k < p.size(); ++k) {
      p.x[k] += move;
      p.y[k] += move;
    }
    std::vector<char> passed(domain.grid.size(), 0);
    for (const std::size_t row : domain.soil_ties)
      passed[domain.ties().tied(row)] = 1;
    clear(domain, ScatterPart::motion, domain.soil_rows);
    add_particles(domain, ScatterPart::motion, 0);
    std::size_t touched = 0;
    for (std::size_t row = 0; row < domain.ties().tied_count(); ++row) {
      const std::size_t node = domain.ties().tied(row);
      if (domain.grid.mass[node] == 0.0)
        continue;
      ++touched;
      EXPECT_TRUE(passed[node]) << "node " << node << ", particles moved by " << move << " m";
    }
    EXPECT_GT(touched, 0u);
    EXPECT_LT(domain.soil_ties.size(), domain.ties().tied_count() / 2);
  }
}

/// One cell wide or eight: a wave that does not vary along x is the same.
TEST(PeriodicColumn, IsAsGoodAsAWideDomain) {
  std::vector<Particles> results;
  for (const double box_width : {h, 8.0 * h}) {
    Domain domain = periodic_box(box_width, Transfer::apic, StepOrder::musl);
    Particles& p = domain.sets.front();
    for (std::size_t k = 0; k < p.size(); ++k)
      p.vx[k] = 0.1 * std::cos(std::numbers::pi * p.y[k] / depth);
    Stepper stepper(domain, 0.0, test_support::no_traction(domain));
    for (int i = 0; i < 400; ++i)
      stepper.step();
    results.push_back(p);
  }
  const Particles& narrow = results[0];
  const Particles& wide = results[1];
  double difference = 0.0;
  double largest = 0.0;
  for (std::size_t id = 0; id < narrow.size(); ++id) {
    const std::size_t twin = id % 2 + id / 2 * 16;
    const std::size_t k = narrow.index_of[id];
    largest = std::max(largest, std::abs(narrow.sxy[k]));
    difference = std::max(difference, std::abs(narrow.sxy[k] - wide.sxy[wide.index_of[twin]]));
  }
  EXPECT_GT(largest, 1e3);
  EXPECT_LT(difference, 1e-9 * largest);
}

/// Under its own weight: overburden, K_0 = nu/(1 - nu), no shear.
TEST(PeriodicColumn, StandsUnderItsWeight) {
  Spec spec = test_support::elastic_box(h, depth, h);
  spec.sides = mpm_domain::Sides::periodic;
  spec.gravity = 9.81;
  Domain domain(spec);
  relax_under_gravity(domain, {}, [](long, double) {});
  const Particles& p = domain.sets.front();
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(p.syy[k], 1700.0 * 9.81 * p.y[k], 50.0);
    EXPECT_NEAR(p.sxx[k], 0.28 / 0.72 * p.syy[k], 50.0);
    EXPECT_NEAR(p.sxy[k], 0.0, 1e-6);
  }
}

} // namespace
} // namespace tremolo::mpm_domain
