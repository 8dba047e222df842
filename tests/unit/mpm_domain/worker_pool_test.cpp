#include "mpm_domain/tiles/worker_pool.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

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
