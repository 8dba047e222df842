#include "mpm_domain/tiles/worker_pool.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <sys/resource.h>

namespace tremolo::mpm_domain {
namespace {

TEST(WorkerPool, RunsEveryTaskOnce) {
  WorkerPool pool(4);
  for (std::size_t count : {0u, 1u, 3u, 1000u})
    for (int repeat = 0; repeat < 50; ++repeat) {
      std::vector<int> done(count, 0);
      pool.run(count, [&](std::size_t i) { ++done[i]; });
      EXPECT_EQ(done, std::vector<int>(count, 1));
    }
}

/// Stacks of 8 MiB each do not fit into an address space of a few: in a process of its own, which keeps the
/// limit.
TEST(WorkerPoolDeathTest, MoreThreadsThanTheSystemAllowsAreRefusedInWords) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs an address space of its own";
#endif
  const auto refused = [] {
    const rlimit little{std::uint64_t{256} << 20, std::uint64_t{256} << 20};
    ::setrlimit(RLIMIT_AS, &little);
    try {
      const WorkerPool pool(600);
    } catch (const std::runtime_error& error) {
      std::fprintf(stderr, "%s\n", error.what());
      std::_Exit(3);
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(refused(), testing::ExitedWithCode(3), "--threads 600: the system allows [0-9]+: ");
}

TEST(WorkerPool, ATaskThatThrowsIsReportedToTheCaller) {
  WorkerPool pool(3);
  EXPECT_THROW(pool.run(10,
                        [](std::size_t i) {
                          if (i == 7)
                            throw std::runtime_error("seven");
                        }),
               std::runtime_error);
  int done = 0;
  pool.run(1, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 1);
}

} // namespace
} // namespace tremolo::mpm_domain
