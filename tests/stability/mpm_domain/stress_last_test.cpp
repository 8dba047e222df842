// Stress updated last (usl) has a limit of its own, below the critical step: a free block with noise, in
// place or beside it, with nodes of next to no mass at its corners. With musl, the default, the same block
// loses energy only up to the critical step.

#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/particle_energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace tremolo::mpm_domain {
namespace {

Spec free_block(Transfer transfer, StepOrder order, double fraction) {
  Spec spec = test_support::elastic_box(3.0, 3.0, 0.5);
  spec.threads = 1;
  spec.scheme = {.transfer = transfer, .order = order, .fraction = fraction};
  return spec;
}

/// Random velocities of 1 mm/s; the block is moved by `shift`.
void set_moving(Domain& domain, double shift) {
  std::mt19937 random(1);
  std::normal_distribution<double> speed(0.0, 1e-3);
  for (Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      p.x[k] += shift;
      p.y[k] += 0.7 * shift;
      p.vx[k] = speed(random);
      p.vy[k] = speed(random);
    }
  sort_particles(domain);
}

/// The largest energy over that at the start.
double growth(const Spec& spec, double shift, long steps) {
  Domain domain(spec);
  set_moving(domain, shift);
  const double start = test_support::particle_energy(domain);
  double largest = 0.0;
  Stepper stepper(domain, 0.0, test_support::no_traction(domain));
  while (stepper.steps() < steps) {
    stepper.step();
    if (stepper.steps() % 16 == 0)
      largest = std::max(largest, test_support::particle_energy(domain) / start);
  }
  return largest;
}

constexpr double shifts[] = {0.0, 1e-3, 0.06, 0.19}; // m

TEST(StressLast, LosesEnergyOnlyUpToItsOwnLimit) {
  for (const Transfer transfer : {Transfer::apic, Transfer::flip}) {
    for (const double shift : shifts)
      EXPECT_LT(growth(free_block(transfer, StepOrder::usl, 0.85), shift, 20000), 1.0) << shift;
    EXPECT_THROW(growth(free_block(transfer, StepOrder::usl, 0.86), 0.0, 1), std::invalid_argument);
  }
}

/// At the critical step, put together by hand, the same block gains energy.
TEST(StressLast, ApicGrowsAtTheCriticalStep) {
  double largest = 0.0;
  for (const double shift : shifts) {
    Domain domain(free_block(Transfer::apic, StepOrder::usl, 1.0));
    domain.boundary.remove_faces();
    set_moving(domain, shift);
    const double dt = critical_time_step(domain, 0.0);
    const double start = test_support::particle_energy(domain);
    for (int step = 0; step < 20000 && largest < 10.0; ++step) {
      scatter(domain, ScatterPart::both);
      grid_velocities(domain, domain.soil_rows);
      largest = std::max(largest, update_grid(domain, dt, domain.soil_rows)[0].value() / start);
      gather(domain, dt, {.velocity = true, .position = true, .strain = true});
    }
  }
  EXPECT_GT(largest, 10.0);
}

TEST(StressLastRemapped, LosesEnergyOnlyUpToTheCriticalStep) {
  for (const double shift : shifts)
    EXPECT_LT(growth(free_block(Transfer::apic, StepOrder::musl, 1.0), shift, 20000), 1.0) << shift;
}

} // namespace
} // namespace tremolo::mpm_domain
