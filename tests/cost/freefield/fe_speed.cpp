// CPU time of a column of 200 elements under 40 s of motion given every 5 ms, MKZ soil, by integrator.

#include "freefield/fe/fe_column.hpp"
#include "tests/cost/freefield/mkz_column.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace {

using namespace tremolo::freefield;

constexpr double duration = 40.0;

void march(benchmark::State& state, FeColumnSettings settings) {
  settings.max_element_size = 0.5;
  if (settings.integrator == Integrator::central_difference) {
    settings.time_step =
        0.9 * central_difference_limit(mkz_profile(), settings.max_element_size, settings.damping);
  }
  while (state.KeepRunning()) {
    FeColumn column(mkz_profile(), settings, strong_shaking(0.3));
    double largest = 0.0;
    long steps = 0;
    const double probe = -0.25;
    while (column.time() < duration) {
      column.step();
      ++steps;
      if (steps % 8 == 0) {
        ColumnSample s;
        column.sample({&probe, 1}, {&s, 1});
        largest = std::max(largest, std::abs(s.vx));
      }
    }
    state.counters["steps"] = static_cast<double>(steps);
    state.counters["iterations"] = static_cast<double>(column.counts().iterations);
    state.counters["halved"] = static_cast<double>(column.counts().halved_steps);
    state.counters["PGV_m_s"] = largest;
  }
}

constexpr Integrator explicitly = Integrator::central_difference;
BENCHMARK_CAPTURE(march, explicit_at_0p9_of_the_limit, {.integrator = explicitly})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(march, newmark_5ms_consistent, {.time_step = 5e-3})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(march, newmark_5ms_initial, {.time_step = 5e-3, .tangent = Tangent::initial})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(march, hht_5ms_consistent, {.time_step = 5e-3, .hht_alpha = -0.1})
    ->Unit(benchmark::kMillisecond);

} // namespace
