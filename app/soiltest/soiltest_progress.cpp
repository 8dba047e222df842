#include "app/soiltest/soiltest_progress.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

namespace tremolo::app {

std::function<void(const soiltest::TestProgress&)> soiltest_progress() {
  using Clock = std::chrono::steady_clock;
  constexpr double first = 3.0; // s
  return [begin = Clock::now(), next = first](const soiltest::TestProgress& progress) mutable {
    const double elapsed = std::chrono::duration<double>(Clock::now() - begin).count();
    if (elapsed < next)
      return;
    next = 2.0 * elapsed;
    fmt::print(stderr, "  after {:.0f} s: increment {} of this test (at most {:.3g}), strain {:.3g}{}\n",
               elapsed, progress.increments, progress.most_increments, progress.strain,
               progress.cycles > 0.0 ? fmt::format(", cycle {:.2f}", progress.cycles) : "");
  };
}

} // namespace tremolo::app
