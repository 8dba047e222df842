#pragma once

#include "mpm_domain/ranks/mpi_communicator.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace tremolo::test_support {

/// The ranks of this test; null where it runs alone.
inline mpm_domain::Communicator* test_ranks() {
  static const std::unique_ptr<mpm_domain::Communicator> ranks = mpm_domain::join_ranks();
  return ranks.get();
}

} // namespace tremolo::test_support

/// Skips a test that needs ranks where there are none.
#define TREMOLO_NEED_RANKS()                                                                                 \
  if (test_support::test_ranks() == nullptr)                                                                 \
  GTEST_SKIP() << "this test is for ranks that mpirun starts, in a build with TREMOLO_MPI"
