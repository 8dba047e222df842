#pragma once

#include <ctime>

namespace tremolo::testing {

/// CPU time that some work takes, s; other processes of the machine do not count.
template <class Work>
double cpu_seconds(Work&& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

} // namespace tremolo::testing
