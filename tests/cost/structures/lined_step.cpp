// What a lining adds to a step of the domain: CPU time of ground of 8,000 and of 50,000 elastic particles,
// bare and around a ring of 64 elements and 40 segments.
//
//   dry_<ground>          above the table
//   undrained_<ground>    under water that moves with the grains
//   coupled_<ground>      under water that flows
//
// The ground has come to rest under gravity, so that the ring is pressed, and sways at 20 mm/s. The counter
// lining_over_rest is what the passes of the lining take over what all others do, in the same steps.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/wet_lining.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace tremolo::cost {
namespace {

using materials::Drainage;
using namespace mpm_domain;

/// @param cells  along each side of the ground, of 0.5 m
Spec ground(std::optional<Drainage> drainage, int cells, bool lined) {
  constexpr double h = 0.5, young = 2e8; // m, Pa
  const double side = cells * h;
  Spec spec = drainage ? test_support::saturated_flat_ground(side, side, h, *drainage, young)
                       : test_support::flat_ground(side, side, h, {1900.0, young, 0.3});
  spec.scheme.order = StepOrder::musl;
  spec.threads = 1;
  if (lined)
    spec.linings = {test_support::concrete_lining({0.13, -0.5 * side + 0.29}, 0.6)};
  return spec;
}

void step_on(benchmark::State& run, std::optional<Drainage> drainage, int cells, bool lined) {
  Domain domain(ground(drainage, cells, lined));
  const Reactions reactions = bring_to_rest(domain, {.residual = 1e-2}, {}, [](std::size_t, long, double) {});
  replace_constraints(domain, reactions);
  const double wave_number = 0.5 * std::numbers::pi / (0.5 * cells);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.vx[k] = 0.02 * std::cos(wave_number * set.y[k]);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  for (auto _ : run)
    stepper.step();
  run.counters["particles"] = static_cast<double>(domain.particle_count());
  double of_lining = 0.0;
  double others = 0.0;
  for (const PassTime& pass : stepper.times())
    (pass.name.starts_with("linings") ? of_lining : others) += pass.seconds;
  run.counters["lining_over_rest"] = of_lining / others;
}

#define GROUNDS(name, drainage)                                                                              \
  BENCHMARK_CAPTURE(step_on, name##_bare_8000, drainage, 45, false);                                         \
  BENCHMARK_CAPTURE(step_on, name##_lined_8000, drainage, 45, true);                                         \
  BENCHMARK_CAPTURE(step_on, name##_bare_50000, drainage, 112, false);                                       \
  BENCHMARK_CAPTURE(step_on, name##_lined_50000, drainage, 112, true)

GROUNDS(dry, std::nullopt);
GROUNDS(undrained, Drainage::undrained);
GROUNDS(coupled, Drainage::coupled);

} // namespace
} // namespace tremolo::cost
