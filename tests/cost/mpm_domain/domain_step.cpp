// Particle updates a second of the domain's step, in CPU time, next to a plain loop that does the least
// (plain_step.hpp): the ratio of both is what carries over to another machine. 102,400 particles where
// nothing else is said.
//
//   domain/<order>_<transfer>     the schemes, elastic soil
//   boxes_follow/...              the same where the particles' boxes follow the soil
//   reduced_dispersion           musl and apic with it
//   matched_layers/<n>            musl and apic on 100 by 40 cells, layers of n cells on three sides; 0:
//                                 dashpots
//   threads/<case>/<n>            the wall clock, for n threads on as many free cores
//   softening/<c>                 Mohr-Coulomb that softens, cohesion c (Pa), each particle with its own
//                                 dilatation: `yielding` tells the share of particles that yield in a step
//   mean_dilatation/<c>           the same with the mean dilatation of cells
//   slices/<n>                    the square in n horizontal slices, each a soil of its own, as soils that
//   vary
//                                 over depth are cut: 160 have the height of a cell
//   graded                        cells of 1, 0.5 and 0.25 m, a third of the depth or less each
//   particles/<case>/<n>/<t>      cost against their number, with t threads, and the bytes that one takes:
//                                 `arrays` its own, `peak` the memory of the process, grid, filling and
//                                 sorting included
//   triad                         a = b + s c over 3 x 64 MiB: what the memory gives, 24 bytes a number

#include "mpm_domain/step/stepper.hpp"
#include "plain_step.hpp"
#include "tests/support/quiet_ground.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

namespace tremolo::cost {
namespace {

using mpm_domain::Particles;
using mpm_domain::StepOrder;
using mpm_domain::Transfer;

constexpr int cells = 160;
constexpr double cell_size = 0.5; // m
const materials::Elasticity soil = {1700.0, 40e6, 0.28};

mpm_domain::Spec square(int cells_a_side, const materials::Law& law, Transfer transfer, StepOrder order,
                        int threads) {
  const double side = cells_a_side * cell_size;
  mpm_domain::Spec spec;
  spec.box = {0.0, 0.0, side, side};
  spec.cell_size = cell_size;
  spec.soils = {{"soil", law}};
  spec.regions = {{0, {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}}}};
  spec.scheme.transfer = transfer;
  spec.scheme.order = order;
  spec.threads = threads;
  return spec;
}

/// A square with a standing shear wave before quiet ground.
struct Shaken {
  mpm_domain::Domain domain;
  mpm_domain::Stepper stepper;

  explicit Shaken(const mpm_domain::Spec& spec)
      : domain(spec), stepper(started(domain), 0.0, test_support::quiet_ground()) {}

  static mpm_domain::Domain& started(mpm_domain::Domain& domain) {
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        set.vx[k] = 0.01 * std::sin(2.0 * std::numbers::pi * set.y[k] / domain.spec.box.y_max);
    return domain;
  }
};

void count_updates(benchmark::State& run, std::size_t particles) {
  run.counters["updates_per_s"] =
      benchmark::Counter(static_cast<double>(particles), benchmark::Counter::kIsIterationInvariantRate);
}

void step_on(benchmark::State& run, Shaken& shaken) {
  for (auto _ : run)
    shaken.stepper.step();
  count_updates(run, shaken.domain.particle_count());
}

materials::Law elastic() {
  return materials::LinearElastic{soil};
}

void domain(benchmark::State& run, Transfer transfer, StepOrder order) {
  Shaken shaken(square(cells, elastic(), transfer, order, 1));
  step_on(run, shaken);
}

void boxes_follow(benchmark::State& run, Transfer transfer, StepOrder order) {
  mpm_domain::Spec spec = square(cells, elastic(), transfer, order, 1);
  spec.boxes = mpm_domain::ParticleBoxes::deforming;
  Shaken shaken(spec);
  step_on(run, shaken);
}

void reduced_dispersion(benchmark::State& run) {
  mpm_domain::Spec spec = square(cells, elastic(), Transfer::apic, StepOrder::musl, 1);
  spec.scheme.dispersion = mpm_domain::Dispersion::reduced;
  Shaken shaken(spec);
  step_on(run, shaken);
}

void matched_layers(benchmark::State& run) {
  mpm_domain::Spec spec = square(100, elastic(), Transfer::apic, StepOrder::musl, 1);
  spec.box.y_max = 40 * cell_size;
  spec.regions.front().polygon = {
      {0.0, 0.0}, {spec.box.x_max, 0.0}, {spec.box.x_max, spec.box.y_max}, {0.0, spec.box.y_max}};
  if (run.range(0) > 0) {
    spec.layer_cells = static_cast<int>(run.range(0));
    spec.matched_sides = {mpm_domain::Side::left, mpm_domain::Side::right, mpm_domain::Side::base};
  }
  Shaken shaken(spec);
  step_on(run, shaken);
}

/// The wave's shear stress reaches some 1.6 kPa.
void softening_soil(benchmark::State& run, mpm_domain::Dilatation dilatation) {
  materials::MohrCoulomb law;
  law.elastic = soil;
  law.cohesion_peak = static_cast<double>(run.range(0));
  law.cohesion_residual = 0.5 * law.cohesion_peak;
  law.friction_peak = std::numbers::pi / 4.0;
  law.friction_residual = 28.0 * std::numbers::pi / 180.0;
  law.softening = 15.0;
  mpm_domain::Spec spec = square(cells, law, Transfer::flip, StepOrder::usl, 1);
  spec.scheme.dilatation = dilatation;
  Shaken shaken(spec);
  const std::vector<double>& plastic_strain = shaken.domain.sets.front().state;
  std::vector<double> before = plastic_strain;
  double yielded = 0.0;
  double updates = 0.0;
  for (auto _ : run) {
    shaken.stepper.step();
    run.PauseTiming();
    for (std::size_t k = 0; k < before.size(); ++k)
      yielded += plastic_strain[k] != before[k] ? 1.0 : 0.0;
    updates += static_cast<double>(before.size());
    before = plastic_strain;
    run.ResumeTiming();
  }
  count_updates(run, before.size());
  run.counters["yielding"] = yielded / updates;
}

void softening(benchmark::State& run) {
  softening_soil(run, mpm_domain::Dilatation::particle);
}

void mean_dilatation(benchmark::State& run) {
  softening_soil(run, mpm_domain::Dilatation::cell);
}

void slices(benchmark::State& run, Transfer transfer, StepOrder order) {
  mpm_domain::Spec spec = square(cells, elastic(), transfer, order, 1);
  const auto count = run.range(0);
  spec.soils.assign(static_cast<std::size_t>(count), spec.soils.front());
  for (std::int64_t i = 1; i < count; ++i)
    spec.regions.front().cuts.push_back(spec.box.y_max *
                                        (1.0 - static_cast<double>(i) / static_cast<double>(count)));
  Shaken shaken(spec);
  step_on(run, shaken);
}

/// Three levels, in bands, with about as many particles as the square.
mpm_domain::Spec bands(Transfer transfer, StepOrder order, int threads) {
  mpm_domain::Spec spec = square(cells, elastic(), transfer, order, threads);
  constexpr double width = 112.0;
  constexpr double depth = 56.0;
  spec.box = {0.0, 0.0, width, depth};
  spec.cell_size = 1.0;
  spec.regions = {{0, {{0.0, 0.0}, {width, 0.0}, {width, depth}, {0.0, depth}}}};
  spec.refine = {{{0.0, 32.0, width, depth}, 1}, {{0.0, 48.0, width, depth}, 2}};
  return spec;
}

void graded(benchmark::State& run, Transfer transfer, StepOrder order) {
  Shaken shaken(bands(transfer, order, 1));
  step_on(run, shaken);
  run.counters["particles"] = static_cast<double>(shaken.domain.particle_count());
}

enum class Mesh { uniform, graded };

void threads(benchmark::State& run, Mesh mesh, Transfer transfer, StepOrder order) {
  const int count = static_cast<int>(run.range(0));
  Shaken shaken(mesh == Mesh::graded ? bands(transfer, order, count)
                                     : square(cells, elastic(), transfer, order, count));
  step_on(run, shaken);
}

/// What a particle of a set takes: its arrays, and what finds it.
double bytes_a_particle(const Particles& set) {
  return static_cast<double>(mpm_domain::bytes_per_particle(set.traits) + sizeof(double) * set.state_size);
}

/// A line of /proc/self/status, e.g. "VmRSS", bytes.
double memory(const std::string& line) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
    if (word == line + ":") {
      double kib = 0.0;
      status >> kib;
      return 1024.0 * kib;
    }
  return 0.0;
}

/// From here on VmHWM is the peak since now.
void forget_peak() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

/// @param run  number of particles, threads
void particles(benchmark::State& run, Transfer transfer, StepOrder order) {
  const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(run.range(0)) / 4.0)));
  forget_peak();
  const double before = memory("VmRSS");
  Shaken shaken(square(side, elastic(), transfer, order, static_cast<int>(run.range(1))));
  shaken.stepper.step(); // the first one touches memory that the kernel has yet to give
  step_on(run, shaken);
  run.counters["arrays"] = bytes_a_particle(shaken.domain.sets.front());
  run.counters["peak"] = (memory("VmHWM") - before) / static_cast<double>(shaken.domain.particle_count());
}

void plain(benchmark::State& run) {
  PlainStep step(cells, cell_size, soil.density, soil.young, soil.poisson);
  const double dt = 0.3 * cell_size / soil.p_wave_speed();
  for (auto _ : run)
    step.step(dt);
  benchmark::DoNotOptimize(step.kinetic_energy());
  count_updates(run, step.particles());
}

void triad(benchmark::State& run) {
  constexpr std::size_t count = 64 << 17; // doubles: 64 MiB
  std::vector<double> a(count, 0.0);
  const std::vector<double> b(count, 1.0);
  const std::vector<double> c(count, 2.0);
  for (auto _ : run) {
    for (std::size_t i = 0; i < count; ++i)
      a[i] = b[i] + 3.0 * c[i];
    benchmark::ClobberMemory();
  }
  run.SetBytesProcessed(run.iterations() * static_cast<std::int64_t>(24 * count));
}

BENCHMARK(plain);
BENCHMARK_CAPTURE(domain, usl_flip, Transfer::flip, StepOrder::usl);
BENCHMARK_CAPTURE(domain, usl_apic, Transfer::apic, StepOrder::usl);
BENCHMARK_CAPTURE(domain, musl_flip, Transfer::flip, StepOrder::musl);
BENCHMARK_CAPTURE(domain, musl_apic, Transfer::apic, StepOrder::musl);
BENCHMARK_CAPTURE(boxes_follow, usl_apic, Transfer::apic, StepOrder::usl);
BENCHMARK_CAPTURE(boxes_follow, musl_apic, Transfer::apic, StepOrder::musl);
BENCHMARK(reduced_dispersion);
BENCHMARK(matched_layers)->Arg(0)->Arg(5)->Arg(10);
BENCHMARK_CAPTURE(slices, usl_flip, Transfer::flip, StepOrder::usl)->Arg(1)->Arg(20)->Arg(80)->Arg(160);
BENCHMARK_CAPTURE(slices, musl_apic, Transfer::apic, StepOrder::musl)->Arg(1)->Arg(20)->Arg(80)->Arg(160);
BENCHMARK_CAPTURE(graded, usl_flip, Transfer::flip, StepOrder::usl);
BENCHMARK_CAPTURE(graded, musl_apic, Transfer::apic, StepOrder::musl);
BENCHMARK_CAPTURE(threads, usl_flip, Mesh::uniform, Transfer::flip, StepOrder::usl)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime();
BENCHMARK_CAPTURE(threads, musl_apic, Mesh::uniform, Transfer::apic, StepOrder::musl)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime();
BENCHMARK_CAPTURE(threads, graded_usl_flip, Mesh::graded, Transfer::flip, StepOrder::usl)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime();
BENCHMARK_CAPTURE(threads, graded_musl_apic, Mesh::graded, Transfer::apic, StepOrder::musl)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime();
BENCHMARK(softening)->Arg(100)->Arg(1000)->Arg(1400)->Arg(2000);
BENCHMARK(mean_dilatation)->Arg(100)->Arg(1000)->Arg(1400)->Arg(2000);
BENCHMARK_CAPTURE(particles, usl_flip, Transfer::flip, StepOrder::usl)
    ->ArgsProduct({{10'000, 102'400, 1'000'000, 10'000'000}, {1}});
BENCHMARK_CAPTURE(particles, musl_apic, Transfer::apic, StepOrder::musl)
    ->ArgsProduct({{102'400, 1'000'000, 10'000'000}, {1, 2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(triad);

} // namespace
} // namespace tremolo::cost
