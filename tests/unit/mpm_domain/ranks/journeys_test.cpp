// Particles that go from rank to rank.

#include "mpm_domain/particles/journey.hpp"

#include "mpm_domain/ranks/communicator.hpp"
#include "tests/unit/mpm_domain/ranks/test_ranks.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace tremolo {
namespace {

using mpm_domain::Journey;
using mpm_domain::Particles;

constexpr std::size_t blocks_of_rank = 3;
constexpr std::size_t per_block = 2;
constexpr std::size_t per_rank = blocks_of_rank * per_block;

/// The particles of a rank: each is at x = id, and ids rise with blocks.
Particles set_of(std::size_t rank, std::size_t ranks) {
  Particles set;
  set.state_size = 2;
  set.index_of.give(ranks * per_rank);
  set.for_fields([](const mpm_domain::ParticleFieldDescription&, std::vector<double>& values) {
    values.resize(per_rank);
  });
  set.block_start.assign(ranks * blocks_of_rank + 1, 0);
  for (std::size_t block = 0; block < ranks * blocks_of_rank; ++block)
    set.block_start[block + 1] = set.block_start[block] + (block / blocks_of_rank == rank ? per_block : 0);
  for (std::size_t k = 0; k < per_rank; ++k) {
    const std::size_t id = rank * per_rank + k;
    set.id.push_back(static_cast<std::uint32_t>(id));
    set.index_of.put(id, k);
    set.x[k] = static_cast<double>(id);
    set.syy[k] = -set.x[k];
    set.state.insert(set.state.end(), {set.x[k] + 0.25, set.x[k] + 0.5});
  }
  return set;
}

void expect_whole(const Particles& set) {
  for (std::size_t k = 0; k < set.id.size(); ++k) {
    const double x = set.id[k];
    EXPECT_EQ(set.x[k], x);
    EXPECT_EQ(set.syy[k], -x);
    EXPECT_EQ(set.state[2 * k], x + 0.25);
    EXPECT_EQ(set.state[2 * k + 1], x + 0.5);
    EXPECT_EQ(set.index_of[set.id[k]], k);
    const std::size_t block = set.id[k] / per_block;
    EXPECT_LE(set.block_start[block], k);
    EXPECT_GT(set.block_start[block + 1], k);
  }
}

TEST(Journey, BringsParticlesBetweenThoseThatStay) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  const auto own = static_cast<std::size_t>(ranks.rank());
  const auto count = static_cast<std::size_t>(ranks.size());
  Particles set = set_of(own, count);
  Journey journey(ranks, set);
  for (std::size_t k = 0; k < per_rank; ++k)
    if (k % 2 == 0)
      journey.go(k, static_cast<int>((own + 1) % count));
    else
      journey.stay(k);
  EXPECT_EQ(journey.count(), count * per_rank / 2);
  journey.arrive(set, count * blocks_of_rank);

  std::vector<std::uint32_t> ids;
  for (std::size_t id = 0; id < count * per_rank; ++id) {
    const std::size_t rank = id / per_rank;
    if (id % 2 == 1 ? rank == own : (rank + 1) % count == own)
      ids.push_back(static_cast<std::uint32_t>(id));
  }
  EXPECT_EQ(set.id, ids);
  expect_whole(set);
  EXPECT_EQ(set.index_of[own * per_rank], Particles::nowhere);
}

TEST(Journey, TakesLuggageToACopy) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  const auto count = static_cast<std::size_t>(ranks.size());
  const Particles set = set_of(static_cast<std::size_t>(ranks.rank()), count);
  Journey journey(ranks, set);
  for (std::size_t k = 0; k < per_rank; k += 3)
    journey.go(k, 0);
  Particles copy;
  copy.state_size = set.state_size;
  copy.index_of.give(set.index_of.size());
  const auto add = [&](std::size_t k, std::vector<double>& to) {
    to.insert(to.end(), {100.0 + set.x[k], 200.0 + set.x[k]});
  };
  const std::vector<double> luggage = journey.arrive(copy, count * blocks_of_rank, {2, add});
  expect_whole(copy);
  ASSERT_EQ(copy.id.size(), ranks.rank() == 0 ? count * per_rank / 3 : 0);
  ASSERT_EQ(luggage.size(), 2 * copy.id.size());
  for (std::size_t k = 0; k < copy.id.size(); ++k) {
    EXPECT_EQ(luggage[2 * k], 100.0 + copy.x[k]);
    EXPECT_EQ(luggage[2 * k + 1], 200.0 + copy.x[k]);
  }
}

} // namespace
} // namespace tremolo
