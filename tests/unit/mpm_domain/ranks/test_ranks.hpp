#pragma once

#include "mpm_domain/ranks/mpi_communicator.hpp"
#include "mpm_domain/tiles/deal.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>

namespace tremolo::test_support {

/// The ranks of this test; null where it runs alone.
inline mpm_domain::Communicator* test_ranks() {
  static const std::unique_ptr<mpm_domain::Communicator> ranks = mpm_domain::join_ranks();
  return ranks.get();
}

/// Lets the tiles of the last rank seem to have cost a thousand times what others have.
inline void slow_down_last(mpm_domain::RankShare& share) {
  if (share.ranks->rank() + 1 < share.ranks->size())
    return;
  for (std::size_t tile = 0; tile < share.updates.size(); ++tile)
    if (share.is_mine(tile))
      share.times.add(tile, 1'000'000 * share.updates[tile]);
}

} // namespace tremolo::test_support

/// Skips a test that needs ranks where there are none.
#define TREMOLO_NEED_RANKS()                                                                                 \
  if (test_support::test_ranks() == nullptr)                                                                 \
  GTEST_SKIP() << "this test is for ranks that mpirun starts, in a build with TREMOLO_MPI"
