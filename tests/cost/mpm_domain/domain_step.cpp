// Particle updates a second of the domain's step, for 102,400 particles, next to a plain loop that does the
// least (plain_step.hpp). The ratio of both is what carries over to another machine.

#include "mpm_domain/stepper.hpp"
#include "plain_step.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::cost {
namespace {

using mpm_domain::StepOrder;
using mpm_domain::Transfer;

constexpr int cells = 160;
constexpr double cell_size = 0.5; // m
const materials::Elasticity soil = {1700.0, 40e6, 0.28};

mpm_domain::Spec square(const materials::Law& law, Transfer transfer, StepOrder order, int threads) {
  constexpr double side = cells * cell_size;
  mpm_domain::Spec spec;
  spec.box = {0.0, 0.0, side, side};
  spec.cell_size = cell_size;
  spec.soils = {{"soil", law}};
  spec.regions = {{0, {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}}}};
  spec.scheme.transfer = transfer;
  spec.scheme.order = order;
  spec.scheme.blend_time = 1.0;
  spec.threads = threads;
  return spec;
}

void count_updates(benchmark::State& run, std::size_t particles) {
  run.counters["updates_per_s"] =
      benchmark::Counter(static_cast<double>(particles), benchmark::Counter::kIsIterationInvariantRate);
}

void domain(benchmark::State& run, const materials::Law& law, Transfer transfer, StepOrder order,
            int threads) {
  mpm_domain::Domain domain(square(law, transfer, order, threads));
  for (mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.vx[k] = 0.01 * std::sin(2.0 * std::numbers::pi * set.y[k] / (cells * cell_size));
  mpm_domain::Stepper stepper(domain, 0.0, [](long, double, auto, auto traction) {
    std::ranges::fill(traction, mpm_domain::Vector{});
  });
  for (auto _ : run)
    stepper.step();
  count_updates(run, domain.particle_count());
}

void plain(benchmark::State& run) {
  PlainStep step(cells, cell_size, soil.density, soil.young, soil.poisson);
  const double dt = 0.3 * cell_size / soil.p_wave_speed();
  for (auto _ : run)
    step.step(dt);
  benchmark::DoNotOptimize(step.kinetic_energy());
  count_updates(run, step.particles());
}

materials::Law elastic() {
  return materials::LinearElastic{soil};
}

/// Yields nearly everywhere: the wave of some 1.6 kPa meets a cohesion of 0.1 kPa.
materials::Law softening() {
  materials::MohrCoulomb law;
  law.elastic = soil;
  law.cohesion_peak = 100.0;
  law.friction_peak = std::numbers::pi / 4.0;
  law.friction_residual = 28.0 * std::numbers::pi / 180.0;
  law.softening = 15.0;
  return law;
}

BENCHMARK(plain)->UseRealTime();
BENCHMARK_CAPTURE(domain, usl_flip, elastic(), Transfer::flip, StepOrder::usl, 1)->UseRealTime();
BENCHMARK_CAPTURE(domain, usl_flip_2_threads, elastic(), Transfer::flip, StepOrder::usl, 2)->UseRealTime();
BENCHMARK_CAPTURE(domain, usl_apic, elastic(), Transfer::apic, StepOrder::usl, 1)->UseRealTime();
BENCHMARK_CAPTURE(domain, musl_flip, elastic(), Transfer::flip, StepOrder::musl, 1)->UseRealTime();
BENCHMARK_CAPTURE(domain, musl_apic, elastic(), Transfer::apic, StepOrder::musl, 1)->UseRealTime();
BENCHMARK_CAPTURE(domain, usl_flip_mohr_coulomb, softening(), Transfer::flip, StepOrder::usl, 1)
    ->UseRealTime();

} // namespace
} // namespace tremolo::cost
