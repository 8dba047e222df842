// Time of one update of PDMY03 (D_R 57 %, 101 kPa, K_0 = 0.5) against the increment of shear strain, cycles
// of 0.05 % and of 1 % at constant volume. One point alone, 100,000 points, and 100,000 that turn as in
// simple shear of space, which takes sines and cosines. Arguments: exponent of the increment, cycles of 1e-5
// times.

#include "cycled_points.hpp"

#include <benchmark/benchmark.h>

namespace tremolo::materials {
namespace {

void updates(benchmark::State& run, std::size_t count, double turning = 0.0) {
  const double increment = std::pow(10.0, static_cast<double>(run.range(0)));
  const double amplitude = 1e-5 * static_cast<double>(run.range(1));
  const Law law = pdmy03({.relative_density = 0.57});
  CycledPoints points(law, count, amplitude, increment, -101e3, turning * increment);
  for (auto _ : run) {
    points.step();
    benchmark::ClobberMemory();
  }
  run.counters["time_per_update"] =
      benchmark::Counter(static_cast<double>(count),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  run.counters["bytes_of_state"] = 8.0 * static_cast<double>(state_variables(law).size());
}

void alone(benchmark::State& run) {
  updates(run, 1);
}
void hundred_thousand(benchmark::State& run) {
  updates(run, 100000);
}
void hundred_thousand_turning(benchmark::State& run) {
  updates(run, 100000, 0.5);
}

BENCHMARK(alone)->ArgsProduct({{-7, -6, -5, -4}, {50, 1000}})->Args({-3, 1000});
BENCHMARK(hundred_thousand)->ArgsProduct({{-7, -6, -5, -4}, {50, 1000}})->Args({-3, 1000});
BENCHMARK(hundred_thousand_turning)->Args({-6, 50});

} // namespace
} // namespace tremolo::materials
