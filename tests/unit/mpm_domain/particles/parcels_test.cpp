#include "mpm_domain/particles/parcels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// Particles at x = 0, 1, 2, ..., whose ids are 10 and more, with a law of two state variables.
Particles set_of(std::vector<std::size_t> block_start, std::size_t count) {
  Particles set;
  set.state_size = 2;
  set.block_start = std::move(block_start);
  set.index_of.give(100);
  set.for_fields([&](const ParticleFieldDescription&, std::vector<double>& values) { values.resize(count); });
  for (std::size_t k = 0; k < count; ++k) {
    set.id.push_back(static_cast<std::uint32_t>(10 + k));
    set.index_of.put(set.id[k], k);
    set.x[k] = static_cast<double>(k);
    set.syy[k] = -set.x[k];
    set.state.insert(set.state.end(), {set.x[k] + 0.25, set.x[k] + 0.5});
  }
  return set;
}

/// What another rank sends of a set: these of its particles.
Parcel parcel_of(Particles set, std::vector<std::size_t> which, std::uint32_t first_id, double first_x) {
  for (std::size_t k = 0; k < set.size(); ++k) {
    set.id[k] += first_id;
    set.x[k] += first_x;
  }
  Parcel parcel;
  with_blocks(set, 0, set.size(), [&](std::size_t k, std::size_t block) {
    if (std::ranges::find(which, k) != which.end())
      pack(set, k, block, parcel);
  });
  return parcel;
}

TEST(Parcels, KnowTheBlockOfAParticle) {
  const Particles set = set_of({0, 0, 2, 2, 3}, 4); // the last one has come since the last sort
  std::vector<std::size_t> blocks;
  with_blocks(set, 1, 4, [&](std::size_t, std::size_t block) { blocks.push_back(block); });
  EXPECT_EQ(blocks, (std::vector<std::size_t>{1, 3, 4}));
}

TEST(Parcels, BringParticlesBetweenThoseThatStay) {
  Particles set = set_of({0, 2, 2, 3}, 3);                                     // block 0: 0 and 1, block 2: 2
  const Parcel later = parcel_of(set_of({0, 0, 0, 0}, 1), {0}, 40, 40.0);      // block 3
  const Parcel between = parcel_of(set_of({0, 0, 3, 3}, 3), {0, 2}, 20, 20.0); // block 1
  rearrange(set, 4, {true, false, true}, std::vector<Parcel>{later, between});
  EXPECT_EQ(set.x, (std::vector<double>{0.0, 20.0, 22.0, 2.0, 40.0}));
  EXPECT_EQ(set.id, (std::vector<std::uint32_t>{10, 30, 32, 12, 50}));
  EXPECT_EQ(set.syy, (std::vector<double>{0.0, 0.0, -2.0, -2.0, 0.0}));
  EXPECT_EQ(set.state, (std::vector<double>{0.25, 0.5, 0.25, 0.5, 2.25, 2.5, 2.25, 2.5, 0.25, 0.5}));
  EXPECT_EQ(set.block_start, (std::vector<std::size_t>{0, 1, 3, 4, 5}));
  EXPECT_EQ(set.index_of[11], Particles::nowhere);
  EXPECT_EQ(set.index_of[32], 2U);
  EXPECT_EQ(set.index_of[12], 3U);
}

TEST(Parcels, CarryWhatGoesWithAParticle) {
  Particles empty = set_of({0}, 0);
  const Particles other = set_of({0, 2}, 2);
  Parcel parcel;
  with_blocks(other, 0, 2, [&](std::size_t k, std::size_t block) {
    pack(other, k, block, parcel);
    parcel.insert(parcel.end(), {100.0 + other.x[k], 200.0 + other.x[k]});
  });
  EXPECT_EQ(rearrange(empty, 1, {}, std::vector<Parcel>{parcel}, 2),
            (std::vector<double>{100.0, 200.0, 101.0, 201.0}));
  EXPECT_EQ(empty.state, other.state);
}

} // namespace
} // namespace tremolo::mpm_domain
