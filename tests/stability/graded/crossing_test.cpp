// A vibrating block flies round a periodic strip, half of whose cells are fine, and crosses from fine to
// coarse and back ten times. Its particles are cut when they first enter the fine cells.

#include "tests/support/box_run.hpp"
#include "tests/support/hard_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

constexpr double length = 12.0; // of the period, m
constexpr double drift = 30.0;  // m/s

/// In the coarse cells at the start; 1 m cells, and half-metre ones for x > 6 m.
Spec strip() {
  Spec spec = elastic_box(length, 6.0, 1.0);
  spec.periodic_sides = true;
  spec.threads = 1;
  spec.refine = {{{6.0, -6.0, length, 0.0}, 1}};
  spec.regions = {{0, {{1.0, -4.0}, {5.0, -4.0}, {5.0, -2.0}, {1.0, -2.0}}}};
  return spec;
}

struct Sums {
  double mass = 0.0;
  Vector momentum;
};

Sums sums_of(const Domain& domain) {
  Sums sum;
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      sum.mass += p.mass[k];
      sum.momentum.x += p.mass[k] * p.vx[k];
      sum.momentum.y += p.mass[k] * p.vy[k];
    }
  return sum;
}

/// A stretching vibration along the block.
void set_moving(Domain& domain) {
  Particles& p = domain.sets.front();
  for (std::size_t k = 0; k < p.size(); ++k)
    p.vx[k] = drift + 0.3 * std::cos(std::numbers::pi * (p.x[k] - 1.0) / 4.0);
}

TEST(HardCase11, ABlockCrossesFromFineToCoarseTwentyTimes) {
  Domain domain(strip());
  domain.faces.clear();
  set_moving(domain);
  const std::size_t count = domain.particle_count();
  const Sums start = sums_of(domain);
  Stepper stepper(domain, 0.0, [](long, double, auto, auto) {});
  const double vibration = [&] {
    const double speed = start.momentum.x / start.mass;
    double sum = 0.0;
    const Particles& p = domain.sets.front();
    for (std::size_t k = 0; k < p.size(); ++k)
      sum += 0.5 * p.mass[k] * (std::pow(p.vx[k] - speed, 2) + p.vy[k] * p.vy[k]);
    return sum;
  }();
  double residual = 0.0;
  double before = 0.0;
  while (stepper.time() < 10.0 * length / drift) {
    stepper.step();
    // Kinetic energy is known half a step before the rest: the mean of two belongs together.
    const double now = domain.energy.residual();
    if (stepper.steps() > 1)
      residual = std::max(residual, std::abs(0.5 * (now + before)));
    before = now;
  }
  const Sums end = sums_of(domain);
  exactly("particles, every one cut once", static_cast<double>(domain.particle_count()),
          4.0 * static_cast<double>(count));
  bounded("change of mass, relative", std::abs(end.mass - start.mass) / start.mass, 1e-14);
  bounded("change of momentum, relative",
          std::hypot(end.momentum.x - start.momentum.x, end.momentum.y - start.momentum.y) / start.momentum.x,
          1e-12);
  bounded("energy that the ledger misses, over that of the vibration", residual / vibration, 0.01);
  double stress = 0.0;
  for (const Particles& p : domain.sets)
    for (const double sxx : p.sxx)
      stress = std::max(stress, std::abs(sxx));
  const materials::Elasticity& soil = materials::elasticity(domain.spec.soils.front().law);
  bounded("largest stress over rho c v of the vibration", stress / (soil.density * soil.p_wave_speed() * 0.3),
          1.0);
}

} // namespace
} // namespace tremolo::mpm_domain
