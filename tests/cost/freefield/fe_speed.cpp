// CPU time of a column of 200 elements under 40 s of motion given every 5 ms, MKZ soil, by integrator.

#include "freefield/fe/fe_column.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;

constexpr double duration = 40.0;
constexpr double record_step = 5e-3;

/// 100 m of soil whose wave speed grows with depth, ten layers of twenty elements.
Profile profile() {
  Profile profile{.half_space = Elasticity::from_wave_speeds(2200.0, 760.0, 1520.0)};
  for (int i = 0; i < 10; ++i) {
    const double vs = 180.0 + 20.0 * i;
    const Elasticity soil = Elasticity::from_wave_speeds(1900.0, vs, 2.0 * vs);
    profile.layers.push_back(
        layer_of(10.0, MasingShear{.elastic = soil, .reference_strain = 6e-4, .exponent = 0.919}));
  }
  return profile;
}

/// A motion of strong shaking, 0.3 m/s at most, linear between the samples of a record.
InputVelocity record() {
  std::vector<double> samples;
  for (int i = 0; i * record_step <= duration + 1.0; ++i) {
    const double t = i * record_step;
    const double envelope = 0.3 * std::pow(t / 8.0, 2) * std::exp(2.0 * (1.0 - t / 8.0));
    samples.push_back(envelope * (std::sin(9.0 * t) + std::sin(23.0 * t + 1.0) + std::sin(41.0 * t)) / 3.0);
  }
  return [samples](double t) {
    const double place = std::clamp(t / record_step, 0.0, static_cast<double>(samples.size() - 2));
    const auto i = static_cast<std::size_t>(place);
    return Velocity{std::lerp(samples[i], samples[i + 1], place - static_cast<double>(i)), 0.0};
  };
}

void march(benchmark::State& state, FeColumnSettings settings) {
  settings.max_element_size = 0.5;
  if (settings.integrator == Integrator::central_difference) {
    settings.time_step =
        0.9 * central_difference_limit(profile(), settings.max_element_size, settings.damping);
  }
  while (state.KeepRunning()) {
    FeColumn column(profile(), settings, record());
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
