// FMPM(k), and APIC and FLIP with stress updated last, at the largest step that a case may take, over many
// steps: nothing may grow, in place or beside it, with nodes of next to no mass at corners and level
// interfaces.

#include "mpm_domain/step/full_mass_matrix.hpp"
#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/particle_energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace tremolo::mpm_domain {
namespace {

Spec free_block(StepOrder order, int fmpm_order) {
  Spec spec = test_support::elastic_box(3.0, 3.0, 0.5);
  spec.threads = 1;
  spec.scheme = {.transfer = Transfer::fmpm, .order = order, .fmpm_order = fmpm_order, .fraction = 1.0};
  return spec;
}

Spec graded_block(StepOrder order, int fmpm_order) {
  Spec spec = free_block(order, fmpm_order);
  spec.refine = {{{1.0, -2.0, 2.0, 0.0}, 1}};
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
  domain.faces.clear();
  domain.static_tractions.clear();
  sort_particles(domain);
}

/// The largest energy over that at the start.
double growth(const Spec& spec, double shift, long steps) {
  Domain domain(spec);
  set_moving(domain, shift);
  const double start = test_support::particle_energy(domain);
  double largest = 0.0;
  Stepper stepper(domain, 0.0, test_support::no_traction());
  while (stepper.steps() < steps) {
    stepper.step();
    if (stepper.steps() % 16 == 0)
      largest = std::max(largest, test_support::particle_energy(domain) / start);
  }
  return largest;
}

class AtTheLargestStep : public testing::TestWithParam<StepOrder> {};

TEST_P(AtTheLargestStep, ABlockInAndOutOfPlaceLosesEnergyOnly) {
  for (const int order : {2, 3, 5, 10})
    for (const double shift : {0.0, 1e-3, 0.06, 0.19}) {
      EXPECT_LT(growth(free_block(GetParam(), order), shift, 10000), 1.0) << order << ", " << shift;
      EXPECT_LT(growth(graded_block(GetParam(), order), shift, 3000), 1.0) << order << ", " << shift;
    }
}

INSTANTIATE_TEST_SUITE_P(Orders, AtTheLargestStep, testing::Values(StepOrder::musl, StepOrder::usf),
                         [](const auto& order) { return order.param == StepOrder::musl ? "musl" : "usf"; });

TEST(AtTheLargestStepForLong, ABlockLosesEnergyOnly) {
  EXPECT_LT(growth(free_block(StepOrder::musl, 10), 0.06, 100000), 1.0);
}

/// Why usl has a limit of its own, lower than the critical step.
TEST(UpdateStressLast, LosesEnergyOnlyUpToItsOwnLimit) {
  for (const Transfer transfer : {Transfer::apic, Transfer::flip}) {
    Spec spec = free_block(StepOrder::usl, 2);
    spec.scheme.transfer = transfer;
    spec.scheme.fraction = 0.85;
    for (const double shift : {0.0, 1e-3, 0.06, 0.19})
      EXPECT_LT(growth(spec, shift, 20000), 1.0) << shift;
    spec.scheme.fraction = 0.86;
    EXPECT_THROW(growth(spec, 0.0, 1), std::invalid_argument);
  }
}

/// At the critical step, put together by hand, the same block gains energy.
TEST(UpdateStressLast, ApicGrowsAtTheCriticalStep) {
  Spec spec = free_block(StepOrder::usl, 2);
  spec.scheme.transfer = Transfer::apic;
  double largest = 0.0;
  for (const double shift : {0.0, 1e-3, 0.06, 0.19}) {
    Domain domain(spec);
    set_moving(domain, shift);
    const double dt = critical_time_step(domain, 0.0);
    const double start = test_support::particle_energy(domain);
    for (int step = 0; step < 20000 && largest < 10.0; ++step) {
      scatter(domain, ScatterPart::both);
      grid_velocities(domain);
      largest = std::max(largest, update_grid(domain, dt).kinetic / start);
      gather(domain, dt, {.velocity = true, .position = true, .strain = true});
    }
  }
  EXPECT_GT(largest, 10.0);
}

/// Why FMPM does not go with usl: strains of v+ at a step that is allowed, in a free block.
TEST(UpdateStressLast, GrowsBelowTheCriticalStep) {
  for (const int order : {2, 10}) {
    Domain domain(free_block(StepOrder::musl, order));
    set_moving(domain, 0.0);
    const double dt = critical_time_step(domain, 0.0);
    const double start = test_support::particle_energy(domain);
    FullMassMatrix matrix(order);
    double kinetic = 0.0;
    for (int step = 0; step < 20000 && kinetic < 10.0 * start; ++step) {
      scatter(domain, ScatterPart::both);
      grid_velocities(domain);
      kinetic = update_grid(domain, dt).kinetic;
      gather(domain, dt, {.strain = true});
      matrix.solve(domain);
      gather(domain, dt, {.velocity = true, .position = true});
      matrix.restore(domain);
    }
    EXPECT_GT(kinetic, 10.0 * start) << order;
  }
}

} // namespace
} // namespace tremolo::mpm_domain
