// A slender block that rocks on stiff ground has Housner's period and restitution, rigid and elastic.

#include "tests/support/rocking_block.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tremolo::mpm_domain {
namespace {

using Block = test_support::RockingBlock;

class RockingBlock : public testing::TestWithParam<bool> {};

TEST_P(RockingBlock, HasHousnersPeriodAndRestitution) {
  Spec spec = Block::spec();
  if (GetParam())
    spec.structures.front().stiffness = Stiffness{4e9, 0.2};
  Block block(spec);
  block.run();
  ASSERT_EQ(block.peaks.size(), 2U);
  const Block::Peak first = block.peaks.front();
  EXPECT_NEAR(first.tilt, 0.5 * Block::alpha, 0.01 * Block::alpha);
  EXPECT_NEAR(first.time, Block::quarter_period(0.5 * Block::alpha), 0.01 * first.time);
  EXPECT_NEAR(block.half_cycle_over_exact(), 1.0, 0.05);
  EXPECT_NEAR(block.measured_restitution(), Block::restitution, 0.05);
  // No entry knows of the restart of a rigid body.
  const double residual = block.scene.domain.energy.residual();
  EXPECT_NEAR(residual, GetParam() ? 0.0 : block.given(), 0.02 * block.given());
  RecordProperty("half_cycle_over_exact", std::to_string(block.half_cycle_over_exact()));
  RecordProperty("restitution", std::to_string(block.measured_restitution()));
}

INSTANTIATE_TEST_SUITE_P(Rigid, RockingBlock, testing::Values(false));
INSTANTIATE_TEST_SUITE_P(AcceptanceElastic, RockingBlock, testing::Values(true));

} // namespace
} // namespace tremolo::mpm_domain
