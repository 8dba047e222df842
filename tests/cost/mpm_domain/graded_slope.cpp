// What a graded mesh saves: the CPU time that the slope of cases/slope_oblique takes for a second of motion,
// on cells of 0.25 m everywhere and on the three levels of its case.toml. Both step with the same time
// step.

#include "mpm_domain/particles/fill/rest_stress.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

namespace tremolo::cost {
namespace {

using mpm_domain::Particles;

materials::MohrCoulomb slope_soil(double cell_size) {
  constexpr double degree = std::numbers::pi / 180.0;
  return materials::for_cell_size({.elastic = {1700.0, 40e6, 0.28},
                                   .cohesion_peak = 4e3,
                                   .friction_peak = 45.0 * degree,
                                   .friction_residual = 28.0 * degree,
                                   .softening = 15.0},
                                  cell_size, 0.25);
}

mpm_domain::Spec slope(bool is_graded) {
  mpm_domain::Spec spec;
  spec.box = {0.0, -20.0, 90.0, 10.0};
  spec.cell_size = is_graded ? 1.0 : 0.25;
  if (is_graded)
    spec.refine = {{{26.0, -8.0, 72.0, 10.0}, 1}, {{34.0, -3.0, 60.0, 10.0}, 2}};
  spec.gravity = 9.81;
  spec.soils = {{"slope", slope_soil(spec.cell_size), {slope_soil(0.5), slope_soil(0.25)}}};
  spec.regions = {{0, {{0.0, -20.0}, {90.0, -20.0}, {90.0, 10.0}, {50.0, 10.0}, {40.0, 0.0}, {0.0, 0.0}}}};
  spec.scheme.fraction = 0.8;
  return spec;
}

/// At rest under its weight, more or less, and then shaken by a shear wave in it, before dashpots alone.
void slope_step(benchmark::State& run, bool is_graded) {
  mpm_domain::Domain domain(slope(is_graded));
  mpm_domain::set_rest_stress(domain.sets, domain.spec);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.vx[k] = 0.05 * std::sin(2.0 * std::numbers::pi * set.y[k] / 20.0);
  mpm_domain::Stepper stepper(domain, 0.0, test_support::quiet_ground());
  for (auto _ : run)
    stepper.step();
  const auto particles = static_cast<double>(domain.particle_count());
  std::size_t across = 0;
  for (const Particles& set : domain.sets)
    across += domain.mesh ? set.size() - set.block_start[domain.block_count()] : 0;
  run.counters["particles"] = particles;
  run.counters["across"] = static_cast<double>(across) / particles;
  run.counters["dt_ms"] = 1e3 * stepper.dt();
  run.counters["updates_per_s"] =
      benchmark::Counter(particles, benchmark::Counter::kIsIterationInvariantRate);
  run.counters["s_per_s"] = benchmark::Counter(stepper.dt(), benchmark::Counter::kIsIterationInvariantRate |
                                                                 benchmark::Counter::kInvert);
}

// The same stretch of motion for both, for a step costs the more the more soil yields.
BENCHMARK_CAPTURE(slope_step, uniform, false)->Unit(benchmark::kMillisecond)->Iterations(200);
BENCHMARK_CAPTURE(slope_step, graded, true)->Unit(benchmark::kMillisecond)->Iterations(200);

} // namespace
} // namespace tremolo::cost
