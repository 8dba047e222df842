// Time of one update of PDMY03 (D_R 57 %, 101 kPa, K_0 = 0.5) against the increment of shear strain, cycles
// of 0.05 % and of 1 % at constant volume. One point alone, and 100,000 points. Arguments: exponent of the
// increment, cycles of 1e-5 times.

#include "cycled_points.hpp"

#include <benchmark/benchmark.h>

namespace tremolo::materials {
namespace {

void updates(benchmark::State& run, std::size_t count) {
  const double increment = std::pow(10.0, static_cast<double>(run.range(0)));
  const double amplitude = 1e-5 * static_cast<double>(run.range(1));
  CycledPoints points(pdmy03({.relative_density = 0.57}), count, amplitude, increment, -101e3);
  for (auto _ : run) {
    points.step();
    benchmark::ClobberMemory();
  }
  run.counters["time_per_update"] =
      benchmark::Counter(static_cast<double>(count),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void alone(benchmark::State& run) {
  updates(run, 1);
}
void hundred_thousand(benchmark::State& run) {
  updates(run, 100000);
}

BENCHMARK(alone)->ArgsProduct({{-7, -6, -5, -4}, {50, 1000}})->Args({-3, 1000});
BENCHMARK(hundred_thousand)->ArgsProduct({{-7, -6, -5, -4}, {50, 1000}})->Args({-3, 1000});

} // namespace
} // namespace tremolo::materials
