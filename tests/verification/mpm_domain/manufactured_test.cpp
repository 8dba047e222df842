// Displacements converge to second order in a manufactured solution; with boxes that keep their size and so
// no longer tile the stretched soil, until a floor.

#include "tests/support/manufactured_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {
namespace {

/// The largest over one period.
double error(double amplitude, int cells, const Scheme& scheme, int particles_per_cell = 2,
             ParticleBoxes boxes = ParticleBoxes::fixed) {
  test_support::ManufacturedBlock block(amplitude, cells, particles_per_cell, scheme, boxes);
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

/// log2 of the ratio of errors from 32 to 64 cells at a strain of 16 %.
double late_order(ParticleBoxes boxes) {
  return std::log2(error(0.05, 32, {}, 2, boxes) / error(0.05, 64, {}, 2, boxes));
}

TEST(ManufacturedBlock, SmallMotionConvergesToSecondOrderWithEveryTransferAndOrder) {
  for (const StepOrder order : {StepOrder::usl, StepOrder::musl})
    for (const Transfer transfer : {Transfer::apic, Transfer::flip})
      expect_second_order(1e-3, {transfer, order});
}

TEST(ManufacturedBlock, SmallMotionConvergesToSecondOrderWithOneToFourParticles) {
  for (const int particles : {1, 3, 4})
    expect_second_order(1e-3, {}, particles);
}

TEST(ManufacturedBlock, ALargeMotionConvergesUntilBoxesNoLongerTile) {
  expect_second_order(0.05, {});
  EXPECT_LT(late_order(ParticleBoxes::fixed), 1.0);
}

TEST(ManufacturedBlock, ALargeMotionConvergesToSecondOrderWithBoxesThatFollowTheSoil) {
  EXPECT_GT(late_order(ParticleBoxes::deforming), 1.8);
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
