// Time of one update of one point, over 100,000 points: a sinusoidal strain path of 200 steps a cycle, so
// that one step in 100 reverses. Masing trials are what an iteration costs that accepts nothing.

#include "materials/law.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::materials {
namespace {

constexpr std::size_t count = 100000;
constexpr int steps_per_cycle = 200;
const Elasticity elastic = {1900.0, 130e6, 0.3};

double strain_at(long step) {
  return 2e-3 * std::sin(2.0 * std::numbers::pi * static_cast<double>(step) / steps_per_cycle);
}

void update_points(benchmark::State& run, const Law& law) {
  std::vector<double> stress(4 * count, -50e3);
  std::vector<double> state(count * state_variables(law).size(), 0.0);
  std::vector<double> work(count, 0.0);
  std::vector<double> strain(4 * count, 0.0);
  const Points points = {
      count,    &stress[0], &stress[count], &stress[2 * count], &stress[3 * count], state.data(),
      &work[0], &strain[0], &strain[count], &strain[2 * count], &strain[3 * count]};
  long step = 0;
  for (auto _ : run) {
    run.PauseTiming();
    const double change = strain_at(step + 1) - strain_at(step);
    ++step;
    for (std::size_t i = 0; i < count; ++i) { // not all points alike
      strain[2 * count + i] = change * (0.5 + static_cast<double>(i % 100) / 100.0);
    }
    run.ResumeTiming();
    update(law, points);
    benchmark::ClobberMemory();
  }
  run.counters["time_per_update"] =
      benchmark::Counter(static_cast<double>(count),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

MohrCoulomb mohr_coulomb() {
  MohrCoulomb soil;
  soil.elastic = elastic;
  soil.cohesion_peak = soil.cohesion_residual = 20e3;
  soil.friction_peak = soil.friction_residual = 0.5;
  return soil;
}

BENCHMARK_CAPTURE(update_points, linear_elastic, Law(LinearElastic{elastic}));
BENCHMARK_CAPTURE(update_points, mohr_coulomb, Law(mohr_coulomb()));
BENCHMARK_CAPTURE(update_points, masing_hyperbolic, Law(MasingShear{elastic, 5e-4, 1.0, 1.0}));
BENCHMARK_CAPTURE(update_points, masing_mkz, Law(MasingShear{elastic, 5e-4, 1.0, 0.92}));
BENCHMARK_CAPTURE(update_points, iwan_20, Law(iwan_shear(elastic, 5e-4, 1.0, 0.92, {.elements = 20})));
BENCHMARK_CAPTURE(update_points, iwan_32, Law(iwan_shear(elastic, 5e-4, 1.0, 0.92)));

/// The cost of one trial or acceptance for a column of 200 points, whose memory stays in the cache.
void column_step(benchmark::State& run, bool accept) {
  constexpr std::size_t elements = 200;
  const Backbone backbone = {50e6, 5e-4, 1.0, 0.92};
  std::vector<double> memory(elements * masing_history_size, 0.0);
  long step = 0;
  double sum = 0.0;
  for (auto _ : run) {
    const double strain = strain_at(++step);
    for (std::size_t i = 0; i < elements; ++i) {
      const MutableMasingHistory history(&memory[i * masing_history_size], masing_history_size);
      if (accept) {
        masing_commit(backbone, history, strain);
      } else {
        sum += masing_response(backbone, history, strain).stress;
      }
    }
    benchmark::DoNotOptimize(sum);
    benchmark::ClobberMemory();
  }
  run.counters["time_per_update"] =
      benchmark::Counter(static_cast<double>(elements),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(column_step, trial, false);
BENCHMARK_CAPTURE(column_step, accept, true);

} // namespace
} // namespace tremolo::materials
