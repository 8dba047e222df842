// The cut of lattices into tiles: every node has one owner, and windows hold what particles may touch.

#include "mpm_domain/tiles/tile_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// Two lattices, neither of which is a whole number of tiles.
TileMap two_lattices() {
  return TileMap({{1.0, 0.0, 0.0, 70, 21, 0}, {0.5, 3.0, 2.0, 33, 8, 70 * 21}});
}

bool holds(const NodeBlock& block, int column, int row) {
  return column >= block.column && column < block.end_column() && row >= block.row && row < block.end_row();
}

TEST(TileMap, GivesEveryNodeOneOwner) {
  const TileMap tiles = two_lattices();
  for (const int level : {0, 1})
    for (int row = 0; row < tiles.lattice(level).ny; ++row)
      for (int column = 0; column < tiles.lattice(level).nx; ++column) {
        int owners = 0;
        for (std::size_t tile = tiles.first(level); tile < tiles.first(level + 1); ++tile)
          owners += holds(tiles.owned(tile), column, row) ? 1 : 0;
        ASSERT_EQ(owners, 1) << level << ": " << column << ", " << row;
        ASSERT_TRUE(holds(tiles.owned(tiles.tile_of(level, column, row)), column, row));
      }
  EXPECT_EQ(tiles.first(2), tiles.count());
}

TEST(TileMap, KnowsTheLevelOfEveryTile) {
  const TileMap tiles = two_lattices();
  for (std::size_t tile = 0; tile < tiles.count(); ++tile)
    EXPECT_EQ(tiles.level_of(tile), tile < tiles.first(1) ? 0 : 1);
}

/// A particle that has gone by a cell in any direction touches four nodes a direction.
TEST(TileMap, WindowsHoldTheStencilsOfParticlesThatHaveMovedByACell) {
  const TileMap tiles = two_lattices();
  const std::size_t tile = tiles.tile_of(0, 40, 10);
  const NodeBlock own = tiles.owned(tile);
  const NodeBlock window = tiles.window(tile);
  for (const int row : {own.row - 1, own.end_row() + 3})
    for (const int column : {own.column - 1, own.end_column() + 3})
      EXPECT_TRUE(holds(window, column, row)) << column << ", " << row;
  EXPECT_EQ(window.columns, window_columns);
  EXPECT_EQ(window.rows, window_rows);
}

TEST(TileMap, WindowsWithNodesOfATileAreThoseAroundIt) {
  const TileMap tiles = two_lattices();
  for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
    std::vector<std::size_t> expected;
    const int level = tiles.level_of(tile);
    for (std::size_t other = tiles.first(level); other < tiles.first(level + 1); ++other)
      if (!overlap(tiles.owned(tile), tiles.window(other)).empty())
        expected.push_back(other);
    const std::vector<std::size_t> around = tiles.around(tile);
    EXPECT_TRUE(std::ranges::is_sorted(around));
    for (const std::size_t other : expected)
      EXPECT_TRUE(std::ranges::binary_search(around, other)) << other << " around " << tile;
  }
}

} // namespace
} // namespace tremolo::mpm_domain
