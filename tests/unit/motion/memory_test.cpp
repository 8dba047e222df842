#include "motion/fourier.hpp"
#include "motion/record.hpp"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <complex>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>
#include <vector>

namespace tremolo::motion {
namespace {

/// Bytes of the address space that this process takes up.
std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return 4096 * pages;
}

/// Leaves the work more and more address space, to 24 MiB; ends with 0 if it was refused in time and done in
/// the end. GSL's own handler of errors would end the process at once.
template <class Work>
[[noreturn]] void with_little_memory(Work&& work) {
  int refused = 0;
  int done = 0;
  for (std::uint64_t more = 1U << 19U; more <= 24U << 20U; more += 1U << 19U) {
    const rlimit little{address_space() + more, RLIM_INFINITY};
    ::setrlimit(RLIMIT_AS, &little);
    try {
      work();
      ++done;
    } catch (const std::bad_alloc&) {
      ++refused;
    }
  }
  std::fprintf(stderr, "%d refused, %d done\n", refused, done);
  std::_Exit(refused > 0 && done > 0 ? 0 : 1);
}

TEST(MemoryDeathTest, WhatDoesNotFitIsRefused) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs an address space of its own";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const std::vector<double> samples(1U << 17U, 1.0); // 1 MiB
  EXPECT_EXIT(with_little_memory([&] { transform(samples); }), ::testing::ExitedWithCode(0), "refused");
  const std::vector<std::complex<double>> bins(samples.size() / 2 + 1);
  EXPECT_EXIT(with_little_memory([&] { inverse_transform(bins, samples.size()); }),
              ::testing::ExitedWithCode(0), "refused");
  EXPECT_EXIT(with_little_memory([&] { differentiate(samples, 0.01); }), ::testing::ExitedWithCode(0),
              "refused");
}

} // namespace
} // namespace tremolo::motion
