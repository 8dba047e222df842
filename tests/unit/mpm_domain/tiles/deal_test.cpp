// Tiles are dealt in pieces that lie together and hold nearly the same number of particles.

#include "mpm_domain/tiles/deal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// A lattice of so many tiles.
TileMap map_of(int columns, int rows) {
  return TileMap({Lattice{1.0, 0.0, 0.0, columns * tile_columns, rows * tile_rows, 0}});
}

std::vector<std::int64_t> full(const TileMap& tiles) {
  return std::vector<std::int64_t>(tiles.count(), 1024);
}

TEST(Deal, OfFullTilesIsEven) {
  const TileMap tiles = map_of(16, 16);
  for (const int ranks : {1, 2, 3, 4, 7, 16, 64}) {
    const Deal deal = deal_out(tiles, full(tiles), ranks);
    EXPECT_EQ(std::ranges::count(deal.owner, Deal::nobody), 0);
    EXPECT_EQ(std::set<int>(deal.owner.begin(), deal.owner.end()).size(), static_cast<std::size_t>(ranks));
    EXPECT_LE(unevenness(deal, ranks), 1.0 + static_cast<double>(ranks) / 256.0);
  }
}

/// Four ranks of a square of 16 x 16 tiles have a quarter each, two a half: the shortest rims that there are.
TEST(Deal, LeavesShortRims) {
  const TileMap tiles = map_of(16, 16);
  const auto rims = [&](int ranks) {
    const Deal deal = deal_out(tiles, full(tiles), ranks);
    int count = 0; // of pairs of tiles side by side, or one upon the other, on different ranks
    for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
      count += tile % 16 < 15 && deal.owner[tile] != deal.owner[tile + 1] ? 1 : 0;
      count += tile < 240 && deal.owner[tile] != deal.owner[tile + 16] ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(rims(2), 16);
  EXPECT_EQ(rims(4), 32);
  EXPECT_EQ(rims(16), 6 * 16);
}

TEST(Deal, FollowsTheParticles) {
  const TileMap tiles = map_of(8, 8);
  std::vector<std::int64_t> particles(tiles.count(), 0);
  for (std::size_t tile = 0; tile < 32; ++tile)
    particles[tile] = tile < 8 ? 3000 : 500;
  const Deal deal = deal_out(tiles, particles, 3);
  EXPECT_LT(unevenness(deal, 3), 1.15);
  // Tiles above those with particles belong to an owner below, all others to nobody.
  for (std::size_t tile = 32; tile < 40; ++tile)
    EXPECT_NE(deal.owner[tile], Deal::nobody);
  for (std::size_t tile = 40; tile < 64; ++tile)
    EXPECT_EQ(deal.owner[tile], Deal::nobody);
}

TEST(Deal, StaysUntilItIsUneven) {
  const TileMap tiles = map_of(8, 8);
  const Deal deal = deal_out(tiles, full(tiles), 2);
  std::vector<std::int64_t> particles = full(tiles);
  for (std::size_t tile = 0; tile < tiles.count(); ++tile)
    if (deal.owner[tile] == 0)
      particles[tile] = 1300; // over their mean by 1.12
  EXPECT_EQ(follow(deal, tiles, particles, 2).owner, deal.owner);
  for (std::size_t tile = 0; tile < tiles.count(); ++tile)
    if (deal.owner[tile] == 0)
      particles[tile] = 1450; // by 1.17
  const Deal next = follow(deal, tiles, particles, 2);
  EXPECT_NE(next.owner, deal.owner);
  EXPECT_LT(unevenness(next, 2), 1.05);
}

TEST(Deal, IsImprovedWhereThatIsWorthIt) {
  const TileMap tiles = map_of(8, 8);
  const Deal deal = deal_out(tiles, full(tiles), 2);
  std::vector<std::int64_t> particles = full(tiles);
  const auto fill = [&](std::int64_t count) {
    for (std::size_t tile = 0; tile < tiles.count(); ++tile)
      if (deal.owner[tile] == 0)
        particles[tile] = count;
  };
  fill(1060); // over their mean by 1.02
  EXPECT_EQ(improved(deal, tiles, particles, 2).owner, deal.owner);
  fill(1300); // by 1.12
  const Deal next = improved(deal, tiles, particles, 2);
  EXPECT_LT(unevenness(next, 2), 1.05);
  EXPECT_EQ(next.load, particles);
}

TEST(Deal, IsMadeAnewForAnotherMap) {
  const Deal deal = deal_out(map_of(4, 4), full(map_of(4, 4)), 2);
  const TileMap wider = map_of(5, 4);
  EXPECT_EQ(follow(deal, wider, full(wider), 2).owner.size(), 20u);
}

TEST(Deal, LeavesRanksWithoutTilesWhereThereAreTooFew) {
  const TileMap tiles = map_of(2, 1);
  const Deal deal = deal_out(tiles, full(tiles), 4);
  EXPECT_EQ(unevenness(deal, 4), 2.0);
}

/// A block of tiles in the middle of a square of 16 x 16.
std::vector<std::size_t> block(std::size_t columns, std::size_t rows) {
  std::vector<std::size_t> tiles;
  for (std::size_t j = 4; j < 4 + rows; ++j)
    for (std::size_t i = 4; i < 4 + columns; ++i)
      tiles.push_back(16 * j + i);
  return tiles;
}

TEST(Deal, GivesTheFirstRankWhatStructuresTouchAndAsMuchElseAsOthersHave) {
  const TileMap tiles = map_of(16, 16);
  const Together together{block(4, 4), {}};
  const Deal deal = deal_out(tiles, full(tiles), 4, together);
  for (const std::size_t tile : together.of_first)
    EXPECT_EQ(deal.owner[tile], 0);
  EXPECT_LE(unevenness(deal, 4), 1.0 + 4.0 / 256.0);
}

TEST(Deal, GivesTheFirstRankNothingElseWhereStructuresTouchTooMuch) {
  const TileMap tiles = map_of(16, 16);
  const Together together{block(12, 10), {}};
  const Deal deal = deal_out(tiles, full(tiles), 3, together);
  EXPECT_EQ(std::ranges::count(deal.owner, 0), 120);
  EXPECT_EQ(std::ranges::count(deal.owner, 1), 68);
  EXPECT_EQ(std::ranges::count(deal.owner, 2), 68);
  EXPECT_EQ(unevenness(deal, 3, together), 1.0); // no deal is more even
}

TEST(Deal, IsMadeAnewWhereAStructureComesToTilesOfOthers) {
  const TileMap tiles = map_of(16, 16);
  const Deal deal = deal_out(tiles, full(tiles), 4, {block(4, 4), {}});
  EXPECT_EQ(follow(deal, tiles, full(tiles), 4, {block(4, 4), {}}).owner, deal.owner);
  const Deal next = follow(deal, tiles, full(tiles), 4, {block(6, 4), {}});
  for (const std::size_t tile : block(6, 4))
    EXPECT_EQ(next.owner[tile], 0);
}

/// The first and the last tile of each row are one rank's, with particles and without.
TEST(Deal, LeavesGroupsTogether) {
  const TileMap tiles = map_of(16, 16);
  std::vector<std::int64_t> particles = full(tiles);
  std::fill(particles.begin() + 200, particles.end(), 0);
  particles[200 - 8] = 0; // the first of its row
  Together together;
  for (std::size_t row = 0; row < 16; ++row)
    together.groups.push_back({16 * row, 16 * row + 15});
  for (const int ranks : {2, 3, 4, 7}) {
    const Deal deal = deal_out(tiles, particles, ranks, together);
    for (const std::vector<std::size_t>& group : together.groups)
      EXPECT_EQ(deal.owner[group.front()], deal.owner[group.back()]);
    EXPECT_LT(unevenness(deal, ranks), 1.1);
    EXPECT_EQ(follow(deal, tiles, particles, ranks, together).owner, deal.owner);
  }
}

} // namespace
} // namespace tremolo::mpm_domain
