#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <limits>

namespace tremolo::testing {

/// CPU time that some work takes, s, the least of three runs; other processes of the machine do not count.
template <class Work>
double cpu_seconds(Work&& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 3; ++run) {
    const std::clock_t begin = std::clock();
    work();
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

/// How many times as long the work takes on four times the input: 4 where it grows in proportion, 16 where it looks at
/// all pairs. A ratio within one run, so that neither the machine nor the build matters.
/// @param work  takes the size of the input
template <class Work>
double growth(std::size_t size, Work&& work) {
  return cpu_seconds([&] { work(4 * size); }) / cpu_seconds([&] { work(size); });
}

} // namespace tremolo::testing
