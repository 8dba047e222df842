// The slope of cases/slope_oblique has work for many threads at a time.

#include "mpm_domain/domain.hpp"

#include <gtest/gtest.h>

namespace tremolo::mpm_domain {
namespace {

Spec slope(double cell_size) {
  Spec spec;
  spec.box = {0.0, -20.0, 90.0, 10.0};
  spec.cell_size = cell_size;
  spec.gravity = 9.81;
  spec.soils = {{"slope", materials::LinearElastic{{1700.0, 40e6, 0.28}}}};
  spec.regions = {{0, {{0.0, -20.0}, {90.0, -20.0}, {90.0, 10.0}, {50.0, 10.0}, {40.0, 0.0}, {0.0, 0.0}}}};
  return spec;
}

TEST(SlopeTiles, AreAtLeastForty) {
  const Domain uniform(slope(0.5));
  EXPECT_GE(uniform.clock_tiles.front().sums.filled().size(), 40U);
  Spec spec = slope(1.0);
  spec.refine = {{{26.0, -8.0, 72.0, 10.0}, 1}, {{34.0, -3.0, 60.0, 10.0}, 2}};
  const Domain graded(spec);
  EXPECT_GE(graded.clock_tiles.front().sums.filled().size() + graded.clock_tiles.front().across.size(), 40U);
}

} // namespace
} // namespace tremolo::mpm_domain
