// Particles' squares are cut at the edges of regions and structures.

#include "mpm_domain/particles/fill/fill.hpp"
#include "mpm_domain/spec/plot.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::circle;
using test_support::flat_ground;
using test_support::rectangle;
using test_support::structure;

using Polygons = std::vector<std::vector<Vector>>;

TEST(Plot, IsTheSquareOrNothingWithoutStructures) {
  const Polygons ground{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 1.1}, {0.0, 1.1}}};
  EXPECT_EQ(plot_of(ground, Polygons{}, 1.0, 1.0, 0.5).area, 0.25);
  EXPECT_EQ(plot_of(ground, Polygons{}, 1.0, 1.25, 0.5).area, 0.0);
}

TEST(Plot, IsCutByStructuresAndRegions) {
  const Polygons ground{rectangle(0.0, 0.0, 4.0, 1.1)};
  const Polygons block{rectangle(1.15, 1.0, 2.0, 3.0)};
  const Plot plot = plot_of(ground, block, 1.0, 1.0, 0.5); // [0.75, 1.25] by [0.75, 1.25]
  // 0.4 x 0.35 left of the block, 0.1 x 0.25 below it.
  EXPECT_NEAR(plot.area, 0.4 * 0.35 + 0.1 * 0.25, 1e-15);
  EXPECT_NEAR(plot.x, (0.14 * 0.95 + 0.025 * 1.2) / 0.165, 1e-14);
  EXPECT_NEAR(plot.y, (0.14 * 0.925 + 0.025 * 0.875) / 0.165, 1e-14);
  // What stands above the ground takes nothing of it.
  EXPECT_NEAR(plot_of(ground, Polygons{rectangle(0.0, 1.1, 4.0, 3.0)}, 1.0, 1.0, 0.5).area, 0.5 * 0.35,
              1e-15);
}

TEST(Plot, SlopesAreCutExactly) {
  const Polygons ground{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}}};
  const Polygons far{rectangle(10.0, 10.0, 11.0, 11.0)};
  const Plot plot = plot_of(ground, far, 1.0, 1.0, 0.5);
  EXPECT_NEAR(plot.area, 0.125, 1e-15);
  // The strips' middles stand for them: the centroid is off by a hundredth of the square.
  EXPECT_NEAR(plot.x, 1.0 + 0.5 / 6.0, 0.01 * 0.5);
  EXPECT_NEAR(plot.y, 1.0 - 0.5 / 6.0, 0.02 * 0.5);
}

/// The hole that a tunnel takes has its volume, wherever it lies on the lattice.
TEST(Plot, SoilAroundATunnelHasItsVolume) {
  for (const double offset : {0.0, 0.05, 0.13, 0.21}) {
    Spec spec = flat_ground(16.0, 12.0, 0.5, {1900.0, 2e8, 0.3});
    spec.structures = {structure(circle({offset, -5.5 + 0.7 * offset}, 2.5), 300.0, 0.4)};
    const std::vector<Particles> sets = fill(spec, std::nullopt);
    const double volume = std::accumulate(sets.front().volume.begin(), sets.front().volume.end(), 0.0);
    EXPECT_NEAR(16.0 * 12.0 - volume, std::numbers::pi * 6.25, 1e-3 * std::numbers::pi * 6.25) << offset;
    const auto [least, most] = std::ranges::minmax(sets.front().volume);
    EXPECT_GE(least, 0.1 * 0.0625) << offset; // of whole squares
    EXPECT_LE(most, 2.0 * 0.0625) << offset;
    EXPECT_NEAR(std::accumulate(sets.front().mass.begin(), sets.front().mass.end(), 0.0), 1900.0 * volume,
                1e-9 * volume);
  }
}

} // namespace
} // namespace tremolo::mpm_domain
