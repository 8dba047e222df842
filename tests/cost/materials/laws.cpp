// Time of one update of one point.
//
//   yielding/<law>/points/exponent   every point on its yield surface, sheared on by increments of
//   10^exponent;
//                                    alone, and over 100,000 points
//   shaking/<law>                    100,000 points on a sinusoidal strain path of 200 steps a cycle, so that
//                                    one step in 100 reverses
//   copy                             a plain loop that moves as many bytes as the elastic law does
//   column_step                      Masing trials are what an iteration costs that accepts nothing

#include "materials/law/law.hpp"

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

/// Points under K0 = 0.5, not all alike, with the strain increments of a step.
struct Block {
  std::size_t size;
  std::vector<double> stress, state, work, strain;

  Block(const Law& law, std::size_t points)
      : size(points), stress(4 * points, 0.0), state(points * state_variables(law).size()), work(points, 0.0),
        strain(4 * points, 0.0) {
    for (std::size_t i = 0; i < size; ++i) {
      const double vertical = -60e3 - 800.0 * static_cast<double>(i % 100);
      stress[i] = stress[2 * size + i] = 0.5 * vertical;
      stress[size + i] = vertical;
    }
    initialise(law, points_of());
  }

  Points points_of() {
    return {size,     &stress[0], &stress[size], &stress[2 * size], &stress[3 * size], state.data(),
            &work[0], &strain[0], &strain[size], &strain[2 * size], &strain[3 * size]};
  }

  void shear_by(double change) {
    for (std::size_t i = 0; i < size; ++i) {
      strain[2 * size + i] = change * (0.5 + static_cast<double>(i % 100) / 100.0);
    }
  }
};

void count_updates(benchmark::State& run, std::size_t points, const Law& law) {
  run.counters["time_per_update"] =
      benchmark::Counter(static_cast<double>(points),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  run.counters["state_bytes"] = static_cast<double>(8 * state_variables(law).size());
}

void yielding(benchmark::State& run, const Law& law) {
  Block block(law, static_cast<std::size_t>(run.range(0)));
  const Points points = block.points_of();
  block.shear_by(1e-3);
  for (int n = 0; n < 50; ++n) {
    update(law, points);
  }
  block.shear_by(std::pow(10.0, static_cast<double>(run.range(1))));
  for (auto _ : run) {
    update(law, points);
    benchmark::ClobberMemory();
  }
  count_updates(run, block.size, law);
}

void shaking(benchmark::State& run, const Law& law) {
  Block block(law, count);
  const Points points = block.points_of();
  long step = 0;
  for (auto _ : run) {
    run.PauseTiming();
    block.shear_by(strain_at(step + 1) - strain_at(step));
    ++step;
    run.ResumeTiming();
    update(law, points);
    benchmark::ClobberMemory();
  }
  count_updates(run, count, law);
}

/// Six numbers read and six written a point: the elastic law reads eight and writes four.
void copy(benchmark::State& run) {
  std::vector<double> from(6 * count, 1.0);
  std::vector<double> to(6 * count, 0.0);
  for (auto _ : run) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      to[i] = from[i];
    }
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  count_updates(run, count, LinearElastic{elastic});
}

MohrCoulomb mohr_coulomb() {
  MohrCoulomb soil;
  soil.elastic = elastic;
  soil.cohesion_peak = soil.cohesion_residual = 20e3;
  soil.friction_peak = soil.friction_residual = 0.5;
  return soil;
}

MohrCoulomb softening() {
  MohrCoulomb soil = mohr_coulomb();
  soil.friction_residual = 0.4;
  soil.softening = 1.0; // slow, so that it goes on all the time
  return soil;
}

DruckerPrager drucker_prager() {
  return {elastic, 20e3, 0.5, 0.1, ConeMatch::plane_strain};
}

#define TREMOLO_LAW(name, law)                                                                               \
  BENCHMARK_CAPTURE(shaking, name, Law(law));                                                                \
  BENCHMARK_CAPTURE(yielding, name, Law(law))                                                                \
      ->ArgsProduct({{1, static_cast<long>(count)}, {-7, -6, -5, -4, -3}})                                   \
      ->MinTime(0.1)

TREMOLO_LAW(linear_elastic, LinearElastic{elastic});
TREMOLO_LAW(mohr_coulomb, mohr_coulomb());
TREMOLO_LAW(mohr_coulomb_softening, softening());
TREMOLO_LAW(drucker_prager, drucker_prager());
TREMOLO_LAW(masing_hyperbolic, (MasingShear{elastic, 5e-4, 1.0, 1.0}));
TREMOLO_LAW(masing_mkz, (MasingShear{elastic, 5e-4, 1.0, 0.92}));
TREMOLO_LAW(iwan_20, iwan_shear(elastic, 5e-4, 1.0, 0.92, {.elements = 20}));
TREMOLO_LAW(iwan_32, iwan_shear(elastic, 5e-4, 1.0, 0.92));
TREMOLO_LAW(clay_20, multi_yield_clay(elastic, 50e3));
BENCHMARK(copy);

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
