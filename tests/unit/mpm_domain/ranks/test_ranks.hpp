#pragma once

#include "mpm_domain/domain.hpp"
#include "mpm_domain/ranks/mpi_communicator.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace tremolo::test_support {

/// The ranks of this test; null where it runs alone.
inline mpm_domain::Communicator* test_ranks() {
  static const std::unique_ptr<mpm_domain::Communicator> ranks = mpm_domain::join_ranks();
  return ranks.get();
}

/// Lets the tiles in a corner seem to have cost so much for each update, ns, where others have cost 60.
inline void slow_down_corner(mpm_domain::Domain& domain, std::int64_t cost) {
  mpm_domain::RankShare& share = *domain.share;
  for (std::size_t tile = 0; tile < domain.tiles.count(); ++tile)
    if (share.is_mine(tile)) {
      const mpm_domain::NodeBlock nodes = domain.tiles.owned(tile);
      const bool slow = nodes.column < 2 * mpm_domain::tile_columns && nodes.row < 2 * mpm_domain::tile_rows;
      share.times.add(tile, (slow ? cost : 60) * share.updates[tile]);
    }
}

} // namespace tremolo::test_support

/// Skips a test that needs ranks where there are none.
#define TREMOLO_NEED_RANKS()                                                                                 \
  if (test_support::test_ranks() == nullptr)                                                                 \
  GTEST_SKIP() << "this test is for ranks that mpirun starts, in a build with TREMOLO_MPI"
