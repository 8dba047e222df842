// Conservation between particles and grid, and what rigid motions must leave alone.

#include "mpm_domain/gather.hpp"
#include "mpm_domain/grid_update.hpp"
#include "mpm_domain/scatter.hpp"
#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tremolo::mpm_domain {
namespace {

struct Totals {
  double mass = 0.0;
  Vector momentum;
  double spin = 0.0; ///< angular momentum about the origin
};

Totals grid_totals(const Domain& domain) {
  Totals total;
  const Grid& grid = domain.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const std::size_t n = grid.index(i, j);
      total.mass += grid.mass[n];
      total.momentum.x += grid.momentum_x[n];
      total.momentum.y += grid.momentum_y[n];
      total.spin += (grid.x0 + i * grid.h) * grid.momentum_y[n] - (grid.y0 + j * grid.h) * grid.momentum_x[n];
    }
  return total;
}

/// Particles at random places with random velocities.
Domain shuffled_box(Transfer transfer) {
  Spec spec = test_support::elastic_box(6.0, 5.0, 0.5);
  spec.scheme.transfer = transfer;
  return Domain(spec);
}

void shuffle(Domain& domain) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-0.2, 0.2);
  std::normal_distribution<double> speed;
  Particles& p = domain.sets.front();
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.x[k] += place(random);
    p.y[k] += place(random);
    p.vx[k] = speed(random);
    p.vy[k] = speed(random);
    if (!p.cxx.empty()) {
      p.cxx[k] = speed(random);
      p.cxy[k] = speed(random);
      p.cyx[k] = speed(random);
      p.cyy[k] = speed(random);
    }
  }
  sort_by_cell(p, domain.grid, domain.half_size());
}

TEST(Transfer, ScatterConservesMassMomentumAndAngularMomentum) {
  Domain domain = shuffled_box(Transfer::apic);
  shuffle(domain);
  scatter(domain, ScatterPart::both);
  const Particles& p = domain.sets.front();
  Totals expected;
  for (std::size_t k = 0; k < p.size(); ++k) {
    expected.mass += p.mass[k];
    expected.momentum.x += p.mass[k] * p.vx[k];
    expected.momentum.y += p.mass[k] * p.vy[k];
    const auto moment = [](double x, const Axis& axis) {
      const Weights w = gimp_weights(x, axis);
      return second_moment(w, offsets(w, x, axis));
    };
    const double mx = moment(p.x[k], domain.x_axis());
    const double my = moment(p.y[k], domain.y_axis());
    expected.spin += p.mass[k] * (p.x[k] * p.vy[k] - p.y[k] * p.vx[k] + mx * p.cyx[k] - my * p.cxy[k]);
  }
  const Totals grid = grid_totals(domain);
  const double scale = expected.mass; // speeds are of order 1 m/s
  EXPECT_NEAR(grid.mass, expected.mass, 1e-12 * scale);
  EXPECT_NEAR(grid.momentum.x, expected.momentum.x, 1e-12 * scale);
  EXPECT_NEAR(grid.momentum.y, expected.momentum.y, 1e-12 * scale);
  EXPECT_NEAR(grid.spin, expected.spin, 1e-11 * scale);
}

TEST(Transfer, ApicGatherKeepsMomentumAndAngularMomentum) {
  Domain domain = shuffled_box(Transfer::apic);
  shuffle(domain);
  scatter(domain, ScatterPart::motion);
  grid_velocities(domain);
  const Totals before = grid_totals(domain);
  gather(domain, 1e-4, {.velocity = true});
  scatter(domain, ScatterPart::motion);
  const Totals after = grid_totals(domain);
  EXPECT_NEAR(after.momentum.x, before.momentum.x, 1e-11 * before.mass);
  EXPECT_NEAR(after.momentum.y, before.momentum.y, 1e-11 * before.mass);
  EXPECT_NEAR(after.spin, before.spin, 1e-10 * before.mass);
}

TEST(Transfer, InternalForcesSumToZeroAndGravityToTheWeight) {
  Spec spec = test_support::elastic_box(6.0, 5.0, 0.5);
  spec.gravity = 9.81;
  Domain domain(spec);
  shuffle(domain);
  Particles& p = domain.sets.front();
  std::mt19937 random(5);
  std::normal_distribution<double> stress(0.0, 1e5);
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.sxx[k] = stress(random);
    p.syy[k] = stress(random);
    p.sxy[k] = stress(random);
  }
  scatter(domain, ScatterPart::force);
  Vector sum;
  for (std::size_t n = 0; n < domain.grid.size(); ++n) {
    sum.x += domain.grid.force_x[n];
    sum.y += domain.grid.force_y[n];
  }
  const double weight = 1700.0 * 30.0 * 9.81;
  EXPECT_NEAR(sum.x, 0.0, 1e-9 * weight);
  EXPECT_NEAR(sum.y, -weight, 1e-9 * weight);
}

TEST(Transfer, RigidRotationCausesNoStress) {
  Domain domain = shuffled_box(Transfer::apic);
  Particles& p = domain.sets.front();
  const double spin = 0.1; // rad/s
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.vx[k] = -spin * p.y[k];
    p.vy[k] = spin * p.x[k];
    p.cxy[k] = -spin;
    p.cyx[k] = spin;
  }
  scatter(domain, ScatterPart::both);
  grid_velocities(domain);
  const GatherSums sums = gather(domain, 1e-3, {.velocity = true, .position = true, .strain = true});
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(p.sxx[k], 0.0, 1e-8);
    EXPECT_NEAR(p.sxy[k], 0.0, 1e-8);
    EXPECT_NEAR(p.cyx[k], spin, 1e-12);
    EXPECT_NEAR(p.cxy[k], -spin, 1e-12);
  }
  EXPECT_NEAR(sums.elastic, 0.0, 1e-12);
}

TEST(Transfer, BlendIsGivenPerUnitTime) {
  const auto jitter_after = [](double dt, int steps) {
    Spec spec = test_support::elastic_box(6.0, 5.0, 0.5);
    spec.scheme = {.transfer = Transfer::pic_blend, .blend_time = 0.01};
    Domain domain(spec);
    Particles& p = domain.sets.front();
    // A velocity that alternates between the particles of a cell is invisible to the grid: only the blend
    // removes it.
    for (std::size_t k = 0; k < p.size(); ++k)
      p.vx[k] = (static_cast<long>(std::floor(p.x[k] / 0.25)) % 2 == 0) ? 1.0 : -1.0;
    for (int i = 0; i < steps; ++i) {
      scatter(domain, ScatterPart::motion);
      grid_velocities(domain);
      gather(domain, dt, {.velocity = true});
    }
    // Edges of the box do not average out; look at a particle in its middle.
    const auto k = std::find_if(p.index_of.begin(), p.index_of.end(), [&](std::uint32_t i) {
      return std::abs(p.x[i] - 3.0) < 0.2 && std::abs(p.y[i] + 2.5) < 0.2;
    });
    return std::abs(p.vx[*k]);
  };
  EXPECT_NEAR(jitter_after(1e-3, 10), std::exp(-1.0), 1e-6);
  EXPECT_NEAR(jitter_after(5e-4, 20), std::exp(-1.0), 1e-6);
}

TEST(Sort, AParticleOutsideTheGridIsNamedWithItsPlace) {
  Domain domain = shuffled_box(Transfer::flip);
  domain.sets.front().x[0] = 1e3;
  try {
    sort_by_cell(domain.sets.front(), domain.grid, domain.half_size());
    FAIL() << "a particle outside the grid was accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("has left the grid: x = 1000 m"), std::string::npos)
        << error.what();
  }
}

} // namespace
} // namespace tremolo::mpm_domain
