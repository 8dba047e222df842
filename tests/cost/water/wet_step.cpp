// What pore water costs in a step of the domain: CPU time of 102,400 particles under water next to dry ones.
//
//   elastic/dry_<scheme>          elastic soil above the table
//   elastic/drained_<scheme>      under water whose pressure stays hydrostatic
//   elastic/undrained_<scheme>    with a pore pressure, and water that moves with the grains
//   elastic/coupled_<scheme>      with water that flows
//   sand/<drainage>               PM4Sand, apic and musl, at small strain

#include "materials/sand/pm4sand/pm4sand.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace tremolo::cost {
namespace {

using materials::Drainage;
using namespace mpm_domain;

constexpr int cells = 160;
constexpr double cell_size = 0.5; // m
constexpr double side = cells * cell_size;

Spec square(const materials::Law& law, std::optional<Drainage> drainage, Transfer transfer, StepOrder order) {
  Spec spec;
  spec.box = {0.0, -side, side, 0.0};
  spec.cell_size = cell_size;
  spec.gravity = 9.81;
  spec.soils = {{.name = "soil", .law = law}};
  spec.regions = {{0, {{0.0, -side}, {side, -side}, {side, 0.0}, {0.0, 0.0}}}};
  spec.scheme.transfer = transfer;
  spec.scheme.order = order;
  if (drainage) {
    spec.water = {0.0, {}};
    spec.soils.front().pores = {
        .porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-4, .drainage = *drainage};
  }
  return spec;
}

/// Stress of the weight, and a standing shear wave: no gravity stage, which would take long.
void start(Domain& domain) {
  for (Particles& set : domain.sets) {
    for (std::size_t k = 0; k < set.size(); ++k) {
      set.syy[k] = 9.81 * set.weight_share * set.density * set.y[k];
      set.sxx[k] = set.szz[k] = 0.5 * set.syy[k];
      set.vx[k] = 1e-3 * std::sin(2.0 * std::numbers::pi * set.y[k] / side);
    }
    materials::initialise(set.law, set.points(0, set.size()));
  }
}

void step_on(benchmark::State& run, const Spec& spec) {
  Domain domain(spec);
  start(domain);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  for (auto _ : run)
    stepper.step();
  run.counters["updates_per_s"] = benchmark::Counter(static_cast<double>(domain.particle_count()),
                                                     benchmark::Counter::kIsIterationInvariantRate);
}

void elastic(benchmark::State& run, std::optional<Drainage> drainage, Transfer transfer, StepOrder order) {
  step_on(run, square(materials::LinearElastic{{1990.0, 150e6, 0.25}}, drainage, transfer, order));
}

void sand(benchmark::State& run, std::optional<Drainage> drainage) {
  const auto law =
      materials::pm4sand({.density = 1990.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.40});
  step_on(run, square(law, drainage, Transfer::apic, StepOrder::musl));
}

#define SCHEMES(name, drainage)                                                                              \
  BENCHMARK_CAPTURE(elastic, name##_apic_musl, drainage, Transfer::apic, StepOrder::musl);                   \
  BENCHMARK_CAPTURE(elastic, name##_flip_usl, drainage, Transfer::flip, StepOrder::usl)

SCHEMES(dry, std::nullopt);
SCHEMES(drained, Drainage::drained);
SCHEMES(undrained, Drainage::undrained);
SCHEMES(coupled, Drainage::coupled);
BENCHMARK_CAPTURE(sand, dry, std::nullopt);
BENCHMARK_CAPTURE(sand, undrained, Drainage::undrained);
BENCHMARK_CAPTURE(sand, coupled, Drainage::coupled);

} // namespace
} // namespace tremolo::cost
