// Displacements converge to second order in a manufactured solution, until boxes that no longer tile the
// stretched soil set a floor.

#include "tests/support/manufactured_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {
namespace {

/// The largest over one period.
double error(double amplitude, int cells, const Scheme& scheme, int particles_per_cell = 2) {
  test_support::ManufacturedBlock block(amplitude, cells, particles_per_cell, scheme);
  double largest = 0.0;
  while (block.time() < block.period()) {
    block.step();
    largest = std::max(largest, block.displacement_error());
  }
  return largest;
}

void expect_second_order(double amplitude, const Scheme& scheme, int particles_per_cell = 2) {
  const double e8 = error(amplitude, 8, scheme, particles_per_cell);
  const double e16 = error(amplitude, 16, scheme, particles_per_cell);
  EXPECT_GT(std::log2(e8 / e16), 1.8) << e8 << " " << e16;
}

TEST(ManufacturedBlock, SmallMotionConvergesToSecondOrderWithEveryTransferAndOrder) {
  for (const StepOrder order : {StepOrder::usl, StepOrder::usf, StepOrder::musl})
    for (const Transfer transfer : {Transfer::apic, Transfer::flip})
      expect_second_order(1e-3, {transfer, order});
  for (const StepOrder order : {StepOrder::usf, StepOrder::musl})
    expect_second_order(1e-3, {Transfer::fmpm, order});
}

TEST(ManufacturedBlock, SmallMotionConvergesToSecondOrderWithOneToFourParticles) {
  for (const int particles : {1, 3, 4})
    expect_second_order(1e-3, {}, particles);
}

TEST(ManufacturedBlock, ALargeMotionConvergesUntilBoxesNoLongerTile) {
  expect_second_order(0.05, {});
  EXPECT_LT(error(0.05, 64, {}), 0.01);
}

TEST(ManufacturedBlock, WithoutItsBodyForceALargeMotionIsFarOff) {
  test_support::ManufacturedBlock block(0.05, 16, 2, {});
  double largest = 0.0;
  while (block.time() < block.period()) {
    block.step_unforced();
    largest = std::max(largest, block.displacement_error());
  }
  EXPECT_GT(largest, 0.1);
}

} // namespace
} // namespace tremolo::mpm_domain
